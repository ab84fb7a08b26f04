#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/image/metric/metrics.h"

namespace aktina {
namespace {

/// RGB without what is no number; counts what it replaces.
Image cleaned(const Image& picture, uint64_t& replaced) {
  Image out(picture.width, picture.height, 3);
  replaced = 0;
  for (const float value : picture.pixels) replaced += !std::isfinite(value);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      Rgb c = picture.rgb(x, y);
      for (int i = 0; i < 3; ++i) c[i] = std::isfinite(c[i]) ? c[i] : 0;
      out.set_rgb(x, y, c);
    }
  }
  return out;
}

void clip(Image& image) {
  for (float& value : image.pixels) value = std::clamp(value, 0.0f, 1.0f);
}

/// Luminance as a screen encodes it, or as it is.
Image luminances(const Image& image, bool encoded) {
  Image out(image.width, image.height, 1);
  for (size_t i = 0; i < out.pixels.size(); ++i) {
    const float l = luminance({image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]});
    out.pixels[i] = encoded ? linear_to_srgb(l) : l;
  }
  return out;
}

double mean(const Image& map) {
  double sum = 0;
  for (const float value : map.pixels) sum += value;
  return sum / double(map.pixels.size());
}

float largest(const Image& image) { return *std::max_element(image.pixels.begin(), image.pixels.end()); }

}  // namespace

ImageComparison compare(const Image& picture, const Image& reference, DynamicRange range) {
  if (picture.width != reference.width || picture.height != reference.height)
    throw Error(Code::usage, "compare",
                fmt::format("the pictures differ in size: {} x {} and {} x {}", picture.width, picture.height,
                            reference.width, reference.height));
  if (picture.empty()) throw Error(Code::usage, "compare", "the pictures are empty");
  ImageComparison result;
  Image a = cleaned(picture, result.non_finite_a), b = cleaned(reference, result.non_finite_b);
  result.flip_hdr =
      range == DynamicRange::high || (range == DynamicRange::automatic && std::max(largest(a), largest(b)) > 1);
  if (!result.flip_hdr) clip(a), clip(b);
  compare_values(a, b, result.flip_hdr ? 0 : 1, result);
  const Image la = luminances(a, !result.flip_hdr), lb = luminances(b, !result.flip_hdr);
  const float top = result.flip_hdr ? std::max(largest(la), largest(lb)) : 1;
  result.ssim = structural_similarity(la, lb, top > 0 ? top : 1);
  result.flip = mean(result.flip_hdr ? flip_map_hdr(a, b) : flip_map(a, b));
  return result;
}

}  // namespace aktina
