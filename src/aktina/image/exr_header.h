#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace aktina {

/// Walks over the attributes of an OpenEXR file's headers: the library takes memory for whatever size one claims.
/// @throws Error bad_input where an attribute reaches beyond the end of the file, or has another size than its type;
/// unsupported (deep pictures, ID manifests)
void check_exr_header(std::span<const uint8_t> bytes, const std::string& where);

}  // namespace aktina
