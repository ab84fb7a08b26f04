#include "aktina/radiosity/error_estimate.h"

#include <cmath>

#include "aktina/base/statistics.h"

namespace aktina {
namespace {

/// Mean square over a triangle of what is linear between its corners.
double mean_square(double a, double b, double c) { return (a * a + b * b + c * c + (a + b + c) * (a + b + c)) / 12; }

double triangle_area(const PatchMesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  return 0.5 * double(length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a])));
}

}  // namespace

std::vector<float> patch_errors(const Solution& s) {
  std::vector<float> errors;
  errors.reserve(s.mesh.size());
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const auto& c = s.mesh.patches[i];
    const double value = double(luminance(s.irradiances[i].v));
    double off[4];
    for (size_t k = 0; k < 4; ++k) off[k] = double(luminance(s.vertex_irradiances[c[k]].v)) - value;
    const double first = triangle_area(s.mesh, c[0], c[1], c[2]), second = triangle_area(s.mesh, c[0], c[2], c[3]);
    const double sum = first * mean_square(off[0], off[1], off[2]) + second * mean_square(off[0], off[2], off[3]);
    errors.push_back(first + second > 0 ? float(std::sqrt(sum / (first + second))) : 0);
  }
  return errors;
}

double relative_error(const Solution& s) {
  const std::vector<float> errors = patch_errors(s);
  Sum square, light, area;
  for (size_t i = 0; i < errors.size(); ++i) {
    const double a = double(s.mesh.areas[i]);
    square.add(a * double(errors[i]) * double(errors[i])), light.add(a * double(luminance(s.irradiances[i].v)));
    area.add(a);
  }
  return light.value() > 0 ? std::sqrt(square.value() * area.value()) / light.value() : 0;
}

}  // namespace aktina
