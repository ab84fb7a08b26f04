// What the two halves of the OpenEXR codec share.
#pragma once

#include "aktina/image/codec.h"

namespace aktina {

std::vector<uint8_t> encode_exr(const LayeredImage& picture, const ImageWriteOptions& options);

}  // namespace aktina
