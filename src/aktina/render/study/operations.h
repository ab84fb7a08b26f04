// Arithmetic that a method does by its published form: forward differences along a span, one value a channel. Counted
// from its plan, or as its paper states it where it works on spans; the engine's SIMD code evaluates the same
// polynomials in closed form.
#pragma once

#include <optional>
#include <string_view>

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

struct Operations {
  double additions = 0, multiplications = 0, divisions = 0, square_roots = 0, powers = 0, evaluations = 0;
  friend bool operator==(const Operations&, const Operations&) = default;
};

/// Of a pixel, for colours of three channels. Within an evaluation of the model only powers are counted.
/// @param lamps  each costs one power in an evaluation of Phong's or Blinn's model
/// @return  nothing where the work depends on the triangle, as with tests for highlights
std::optional<Operations> operations_per_pixel(std::string_view shading, const ShadingPlan& plan, double lamps);

/// Of a triangle's set-up: the model's evaluations at its lattice, and the coefficients of its polynomials.
std::optional<Operations> operations_per_triangle(std::string_view shading, const ShadingPlan& plan);

}  // namespace aktina
