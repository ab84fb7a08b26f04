#include "aktina/render/study/surface_grid.h"

#include <cmath>

namespace aktina {
namespace {

constexpr double kPlaces = 1 << 20;  // per metre

Vec3 rounded(Vec3d v) {
  const auto place = [](double x) { return float(std::round(x * kPlaces) / kPlaces) + 0.0f; };
  return {place(v.x), place(v.y), place(v.z)};
}

void add_triangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  const Vec3 across = triangle_cross(mesh, {a, b, c});
  if (squared_length(across) < 1e-20f) return;
  const bool front = dot(across, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) >= 0;
  mesh.triangles.push_back(front ? std::array{a, b, c} : std::array{a, c, b});
}

}  // namespace

void add_grid(Mesh& mesh, int columns, int rows, FunctionRef<SurfacePoint3(double, double)> at) {
  const auto first = uint32_t(mesh.positions.size()), width = uint32_t(columns) + 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const SurfacePoint3 p = at(double(i) / columns, double(j) / rows);
      mesh.positions.push_back(rounded(p.position));
      mesh.normals.push_back(normalize_or(rounded(p.normal), {0, 1, 0}));
    }
  for (uint32_t j = 0; j < uint32_t(rows); ++j)
    for (uint32_t i = 0; i < uint32_t(columns); ++i) {
      const uint32_t a = first + j * width + i, b = a + 1, c = a + width, d = c + 1;
      add_triangle(mesh, a, b, d);
      add_triangle(mesh, a, d, c);
    }
}

}  // namespace aktina
