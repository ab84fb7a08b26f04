#include "aktina/render/study/operations.h"

#include <cmath>

#include "aktina/raster/plane_layout.h"

namespace aktina {
namespace {

constexpr double kColours = 3;

/// Making a vector unit: three products and two sums for its square, a root, a division, three products.
constexpr Operations kUnit{.additions = 2, .multiplications = 6, .divisions = 1, .square_roots = 1};

void add_to(Operations& to, const Operations& o, double times = 1) {
  to.additions += times * o.additions, to.multiplications += times * o.multiplications;
  to.divisions += times * o.divisions, to.square_roots += times * o.square_roots;
  to.powers += times * o.powers, to.evaluations += times * o.evaluations;
}

int channels(const ShadingPlan& plan) { return plan.kind == ShadingPlan::Kind::colour ? int(kColours) : plan.channels; }

/// Coefficients of one channel from its values at the lattice.
Operations coefficients(int degree) {
  if (degree == 0) return {};
  if (degree == 1) return {.additions = 4, .multiplications = 4};  // two differences, times the inverse of two edges
  const float* matrix = lattice_to_polynomial(degree);
  const int terms = (degree + 1) * (degree + 2) / 2;
  Operations sum;
  for (int row = 0; row < terms; ++row) {
    int used = 0;
    for (int column = 0; column < terms; ++column) {
      const float value = matrix[row * terms + column];
      if (value == 0) continue;
      ++used;
      if (std::abs(value) != 1) ++sum.multiplications;
    }
    if (used > 1) sum.additions += used - 1;
  }
  return sum;
}

/// What methods on scanlines do at a pixel: for each lamp, and beside.
struct Loop {
  std::string_view shading;
  Operations lamp, rest;
};

constexpr Operations add(Operations a, const Operations& b) {
  a.additions += b.additions, a.multiplications += b.multiplications, a.powers += b.powers;
  return a;
}

/// A cosine that is known, as the light of a lamp in three channels: of diffuse light; of a highlight.
constexpr Operations kGlow{.additions = 3, .multiplications = 3}, kShine = add(kGlow, {.powers = 1});
/// Diffuse and specular light from two cosines.
constexpr Operations lit_by(const Operations& diffuse, const Operations& highlight) {
  return add(add(diffuse, kGlow), add(highlight, kShine));
}
constexpr Operations kParabola{.additions = 2}, kWave{.additions = 1, .multiplications = 1};
constexpr Operations kTwoWaves{.additions = 3, .multiplications = 2}, kProduct{.additions = 2, .multiplications = 3};
constexpr Operations kGouraud{.additions = 3};

constexpr Loop kLoops[] = {
    {"fence", {}, kGouraud},
    {"fast_phong", lit_by(kParabola, kParabola), {}},
    {"euler", lit_by(kParabola, kParabola), {}},
    {"lin", lit_by(kParabola, kParabola), {}},
    {"angular", lit_by(kTwoWaves, kTwoWaves), {}},
    {"angular_decomposed", lit_by(kProduct, kProduct), {}},
    {"angular_combined", lit_by(kWave, kWave), {}},
    {"angular_power", add(add(kWave, kGlow), add(kParabola, kGlow)), {}},  // the parabola is the power
    {"spherical", {.powers = 1}, {.additions = 6, .multiplications = 3, .evaluations = 1}},
    {"cho_neumann_woo", {}, kGouraud},
    {"brown", add(kParabola, kShine), kGouraud},
    {"overveld_highlights", add({.additions = 4, .multiplications = 2}, kShine), kGouraud},
    {"vlasic", add({.additions = 8, .multiplications = 3}, kGlow), kGouraud},  // between four texels of the map
};

/// Nothing of methods that do different things on different triangles: their evaluations tell.
bool depends_on_triangle(std::string_view shading) {
  return shading == "h_test" || shading == "lai_tai" || shading == "tai_hsu";
}

std::optional<Operations> on_scanlines(std::string_view shading, double lamps) {
  for (const Loop& loop : kLoops) {
    if (loop.shading != shading) continue;
    Operations sum = loop.rest;
    add_to(sum, loop.lamp, lamps);
    return sum;
  }
  return {};
}

}  // namespace

std::optional<Operations> operations_per_pixel(std::string_view shading, const ShadingPlan& plan, double lamps) {
  if (depends_on_triangle(shading)) return {};
  if (plan.kind == ShadingPlan::Kind::spans) return on_scanlines(shading, lamps);
  Operations sum{.additions = double(plan.degree * channels(plan))};
  if (plan.perspective) {
    sum.additions += 1, sum.divisions += 1;
    sum.multiplications += channels(plan);
  }
  if (plan.kind == ShadingPlan::Kind::colour) return sum;
  if (plan.normal && shading != "quadratic_normals") add_to(sum, kUnit);  // which is what that method is for
  sum.evaluations += 1, sum.powers += lamps;
  sum.additions += kColours;  // diffuse and specular light
  return sum;
}

std::optional<Operations> operations_per_triangle(std::string_view, const ShadingPlan& plan) {
  if (plan.kind == ShadingPlan::Kind::spans) return {};
  Operations sum{.additions = 5, .multiplications = 6, .divisions = 1};  // the inverse of two edges
  add_to(sum, coefficients(plan.degree), channels(plan));
  if (plan.kind == ShadingPlan::Kind::colour)
    sum.evaluations = double(lattice(plan.degree).size());
  else if (plan.needs & ShadingPlan::kRadiance)
    sum.evaluations = 3;
  return sum;
}

}  // namespace aktina
