// From scene luminance to what a screen shows.
#pragma once

#include "aktina/image/image.h"

namespace aktina {

enum class ToneCurve { none, reinhard, filmic };

struct ToneMapping {
  /// Factor on linear values before the curve; 0: chosen from the picture (see automatic_exposure).
  float exposure = 0;
  ToneCurve curve = ToneCurve::none;
};

/// Exposure that maps the picture's brightness to middle grey: 0.18 over its log-average luminance, limited so that no
/// more than 1 % of the pixels clip. Reinhard et al., "Photographic Tone Reproduction for Digital Images", SIGGRAPH
/// 2002, eq. 1. 1 for a black picture.
float automatic_exposure(const Image& picture);

/// Exposed, tone-mapped, still linear, in [0, 1]; NaN becomes 0.
Rgb tone_map(Rgb linear, float exposure, ToneCurve curve);

}  // namespace aktina
