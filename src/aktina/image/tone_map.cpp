#include "aktina/image/tone_map.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

/// Fit to the curve of the Academy Color Encoding System. K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016.
float filmic(float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

}  // namespace

float automatic_exposure(const Image& picture) {
  double logarithms = 0;
  std::vector<float> brightest;  // of each lit pixel; black ones (a background) say nothing about the exposure
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgb c = picture.rgb(x, y);
      const float l = luminance(c);
      if (!is_finite(c) || !(l > 0)) continue;
      logarithms += std::log(double(l));
      brightest.push_back(max_channel(c));
    }
  }
  if (brightest.empty()) return 1;
  const double grey = 0.18 / std::exp(logarithms / double(brightest.size()));
  const auto may_clip = std::ptrdiff_t(brightest.size() / 100);
  std::nth_element(brightest.begin(), brightest.begin() + may_clip, brightest.end(), std::greater<>());
  const double exposure = std::min(grey, 1 / double(brightest[size_t(may_clip)]));
  return std::isnormal(float(exposure)) ? float(exposure) : 1;
}

Rgb tone_map(Rgb linear, float exposure, ToneCurve curve) {
  Rgb c;
  for (int i = 0; i < 3; ++i) {
    const float v = linear[i] * exposure;
    c[i] = v > 0 ? std::min(v, 1e6f) : 0;  // NaN too; beyond 1e6 every curve is white
  }
  if (curve == ToneCurve::reinhard) c = c / (1 + luminance(c));  // Reinhard et al. 2002, eq. 3, on luminance
  if (curve == ToneCurve::filmic) c = {filmic(c.r), filmic(c.g), filmic(c.b)};
  return clamped(c, 0, 1);
}

}  // namespace aktina
