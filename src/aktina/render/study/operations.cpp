#include "aktina/render/study/operations.h"

#include <cmath>

#include "aktina/raster/plane_layout.h"

namespace aktina {
namespace {

constexpr double kColours = 3;

/// Making a vector unit: three products and two sums for its square, a root, a division, three products.
constexpr Operations kUnit{.additions = 2, .multiplications = 6, .divisions = 1, .square_roots = 1};

void add(Operations& to, const Operations& o, double times = 1) {
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

}  // namespace

std::optional<Operations> operations_per_pixel(std::string_view shading, const ShadingPlan& plan, double powers) {
  if (plan.kind == ShadingPlan::Kind::spans) return {};
  Operations sum{.additions = double(plan.degree * channels(plan))};
  if (plan.perspective) {
    sum.additions += 1, sum.divisions += 1;
    sum.multiplications += channels(plan);
  }
  if (plan.kind == ShadingPlan::Kind::colour) return sum;
  if (plan.normal && shading != "quadratic_normals") add(sum, kUnit);  // which is what that method is for
  sum.evaluations += 1, sum.powers += powers;
  sum.additions += kColours;  // diffuse and specular light
  return sum;
}

std::optional<Operations> operations_per_triangle(std::string_view, const ShadingPlan& plan) {
  if (plan.kind == ShadingPlan::Kind::spans) return {};
  Operations sum{.additions = 5, .multiplications = 6, .divisions = 1};  // the inverse of two edges
  add(sum, coefficients(plan.degree), channels(plan));
  if (plan.kind == ShadingPlan::Kind::colour)
    sum.evaluations = double(lattice(plan.degree).size());
  else if (plan.needs & ShadingPlan::kRadiance)
    sum.evaluations = 3;
  return sum;
}

}  // namespace aktina
