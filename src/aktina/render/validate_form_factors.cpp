// Form factors that are known in closed form, and enclosures, whose rows sum to 1.
#include <cmath>
#include <numeric>

#include "aktina/radiosity/formfactor/closed_forms.h"
#include "aktina/radiosity/formfactor/hemicube.h"
#include "aktina/radiosity/formfactor/matrix.h"
#include "aktina/render/validate_cases.h"

namespace aktina {
namespace {

Polygon floor_square() { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}; }
Polygon ceiling_square() { return {{{0, 1, 1}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1}}}; }
/// Shares the floor's edge x = 0, `degrees` from it.
Polygon hinged_square(double degrees) {
  const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
  return {{{0, 0, 0}, {0, 1, 0}, {c, 1, s}, {c, 0, s}}};
}

std::vector<Polygon> box(double a, double b, double c) {
  const Point3d p[8] = {{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, c}, {a, 0, c}, {a, b, c}, {0, b, c}};
  return {{{p[0], p[1], p[2], p[3]}}, {{p[7], p[6], p[5], p[4]}}, {{p[0], p[4], p[5], p[1]}},
          {{p[1], p[5], p[6], p[2]}}, {{p[2], p[6], p[7], p[3]}}, {{p[3], p[7], p[4], p[0]}}};
}

double row_sum(const std::vector<Polygon>& walls, const std::string& method, size_t row) {
  const auto estimator = make_method(formfactors(), "formfactor", method);
  estimator->build({walls, {}});
  const std::vector<double> factors = estimator->row(row).factors;
  return std::accumulate(factors.begin(), factors.end(), 0.0);
}

double from_floor(const Polygon& to, const std::string& method, std::vector<Polygon> occluders = {}) {
  return form_factor_matrix({{floor_square(), to}, std::move(occluders)}, method).factors[1];
}

}  // namespace

void add_form_factor_cases(std::vector<ValidationCase>& cases) {
  const auto add = [&](std::string name, double reference, double tolerance, std::string source,
                       std::function<double()> compute) {
    cases.push_back({"formfactor", std::move(name), "1", reference, tolerance, std::move(source), std::move(compute)});
  };
  const double opposed = opposed_rectangles(1, 1, 1);
  for (const std::string method : {"contour", "analytic", "ray_cast", "hemicube", "monte_carlo"})
    add(method + ": opposed unit squares 1 m apart", opposed,
        method == "contour"    ? 1e-12
        : method == "analytic" ? 1e-6
                               : 2e-3,
        "Howell C-11", [method] { return from_floor(ceiling_square(), method); });
  add("unit squares at a right angle", perpendicular_rectangles(1, 1, 1), 1e-12, "Howell C-14",
      [] { return from_floor(hinged_square(90), "contour"); });
  const double hinges[][2] = {
      {30, 0.61902832}, {45, 0.48334770}, {60, 0.37090532}, {120, 0.08661500}, {150, 0.02134533}};
  for (const auto& [degrees, factor] : hinges)
    add("unit squares hinged at " + std::to_string(int(degrees)) + " degrees", factor, 5e-9, "quadrature",
        [angle = degrees] { return from_floor(hinged_square(angle), "contour"); });
  add("half plane halfway between opposed unit squares", opposed / 2, 1e-8, "symmetry", [] {
    return from_floor(ceiling_square(), "contour", {{{{0.5, -9, 0.5}, {9, -9, 0.5}, {9, 9, 0.5}, {0.5, 9, 0.5}}}});
  });
  add("a point under the middle of a unit square 1 m above", 0.239456470461, 1e-12, "Lambert", [] {
    const auto method = make_method(formfactors(), "formfactor", "contour");
    method->build({{ceiling_square()}, {}});
    return method->row({0.5, 0.5, 0}, {0, 0, 1}).factors[0];
  });
  add("hemicube of 1024 cells an edge: share of its top", 0.554126424, 1e-6, "(4 / (pi sqrt 2)) atan(1 / sqrt 2)",
      [] { return DeltaFormFactors(1024).top_share(); });
  add("closed box 1 x 1.5 x 0.8 m, largest wall", 1, 1e-12, "closure",
      [] { return row_sum(box(1, 1.5, 0.8), "contour", 0); });
  add("closed box 100 x 1 x 0.1 m, smallest wall", 1, 1e-12, "closure",
      [] { return row_sum(box(100, 1, 0.1), "contour", 3); });
}

}  // namespace aktina
