// Fall-off with distance, apart from the light's own geometry.
#pragma once

namespace aktina {

/// The classic factor f(d) = min(1, 1 / (a0 + a1 d + a2 d^2)). The default, (0, 0, 1) without the clamp, is the
/// physical inverse square law that photometric lights follow.
struct Attenuation {
  float a0 = 0, a1 = 0, a2 = 1;  // 1, m^-1, m^-2
  bool clamp = false;            // to at most 1, as the classic form has it
  bool operator==(const Attenuation&) const = default;
};

/// 1 / (a0 + a1 d + a2 d^2), m^-2 for the physical law; d in metres.
inline float attenuate(const Attenuation& a, float d) {
  const float f = 1 / (a.a0 + d * (a.a1 + d * a.a2));
  return a.clamp && !(f < 1) ? 1 : f;
}

/// Depth cueing 1 / (k1 + k2 d), d the distance from the projection plane: a factor of its own on diffuse and specular
/// light, not the attenuation of a light.
inline float depth_cue(float k1, float k2, float d) { return 1 / (k1 + k2 * d); }

}  // namespace aktina
