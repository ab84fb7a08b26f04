// Every light as one plain struct of numbers, for code that lights many points at a time.
#pragma once

#include "aktina/illumination/light/light.h"

namespace aktina {

/// E / pi = colour * attenuation * cone at a point, towards which the light travels.
struct Lamp {
  bool distant;         // parallel light: `place` is the unit direction towards it
  Vec3 place;           // m, position
  Rgb colour;           // I / pi, cd; E / pi, lx, of a distant one
  bool inverse_square;  // else 1 / (a0 + a1 d + a2 d^2)
  Attenuation attenuation;
  bool cone;
  Vec3 axis;                                      // unit, out of the lamp
  float outer_cosine;                             // dark below it
  float ramp_scale, ramp_offset;                  // square of clamp(scale cos + offset, 0, 1) within the cone
  float exponent;                                 // of the cosine; 0: none
  std::shared_ptr<const PhotometricTable> table;  // multiplies by the intensity about `axis` and `c0`; null: none
  Vec3 c0;
};

Lamp lamp(const Light& light);

}  // namespace aktina
