// Every light as one plain struct of numbers, for code that lights many points at a time.
#pragma once

#include "aktina/illumination/light/light.h"

namespace aktina {

enum class LampShape : uint8_t { point, rectangle, disc };

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
  bool flaps;  // dark outside of the box
  Point3 flap_low, flap_high;
  // Lamps with an area: colour is L / pi, `place` the corner or the centre, `axis` the front's unit normal.
  LampShape shape;
  Vec3 edge_u, edge_v;  // m, of a rectangle
  float radius;         // m, of a disc
  bool both_sides;
};

Lamp lamp(const Light& light);

}  // namespace aktina
