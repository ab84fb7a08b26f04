// A scale of false colours with numbers beside it.
#pragma once

#include <string_view>

#include "aktina/image/image.h"

namespace aktina {

/// The picture with the colours of false_colour() at its right side, from `low` at the bottom to `high` at the top.
/// @param picture  linear RGB, at least 1 x 1. @param unit  of the numbers: digits and the letters of "lx", "cd/m2"
Image with_legend(const Image& picture, double low, double high, std::string_view unit);

}  // namespace aktina
