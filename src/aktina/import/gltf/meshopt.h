// EXT_meshopt_compression: buffer views that meshoptimizer's codecs packed.
#pragma once

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {

/// The unpacked bytes. @param extension  the extension's object on a buffer view
/// @throws Error bad_input, limit
std::vector<uint8_t> unpack_meshopt(Document& document, const Value& extension);

}  // namespace aktina::gltf
