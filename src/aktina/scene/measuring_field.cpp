#include "aktina/scene/measuring_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

/// Cells along a side, as few as keep the spacing.
int cells(double length, double spacing) {
  const double count = std::ceil(length / spacing * (1 - 1e-6));
  if (!(count <= double(kMostMeasuringPoints)))
    throw Error(Code::limit, "spacing", fmt::format("{:g} m is too fine for {:g} m", spacing, length));
  return std::max(1, int(count));
}

void check_count(double count) {
  if (count > double(kMostMeasuringPoints))
    throw Error(Code::limit, "spacing",
                fmt::format("makes {:.3g} measuring points (at most {})", count, kMostMeasuringPoints));
}

/// A triangle cut into equal ones: a point in the middle of each.
void add_triangle(MeasuringField& field, Point3 a, Point3 b, Point3 c, double spacing) {
  const Vec3 across = cross(b - a, c - a);
  const double area = 0.5 * double(length(across));
  if (!(area > 0)) return;
  const double longest = double(std::max({length(b - a), length(c - a), length(c - b)}));
  const int n = cells(longest, spacing);
  check_count(double(field.points.size()) + double(n) * n);
  const float step = 1 / float(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * (n - i) - 1; ++j) {
      const float third = j % 2 ? 2.0f / 3 : 1.0f / 3;  // upright and upside-down ones in turn
      const int pair = j / 2;
      const float s = (float(pair) + third) * step, t = (float(i) + third) * step;
      field.points.push_back(a + s * (b - a) + t * (c - a));
      field.normals.push_back(normalize(across));
      field.areas.push_back(area / (double(n) * n));
    }
}

bool named(const Scene& scene, const Instance& instance, std::string_view name) {
  if (instance.node >= 0 && scene.nodes[size_t(instance.node)].name == name) return true;
  if (instance.mesh >= 0 && scene.meshes[size_t(instance.mesh)].name == name) return true;
  return scene.material_of(instance).name == name;
}

struct WorldTriangles {
  std::vector<std::array<Point3, 3>> all;
  double area = 0;

  void add(const Mesh& mesh, const Mat4& to_world) {
    const bool mirrored = glm::determinant(Mat3(to_world)) < 0;
    for (const auto& t : mesh.triangles) {
      std::array<Point3, 3> p;
      for (size_t k = 0; k < 3; ++k) p[k] = Vec3(to_world * Vec4(mesh.positions[t[k]], 1));
      if (mirrored) std::swap(p[1], p[2]);
      area += 0.5 * double(length(cross(p[1] - p[0], p[2] - p[0])));
      all.push_back(p);
    }
  }
};

}  // namespace

double standard_spacing(double width, double depth) {
  const double longer = std::max(width, depth), shorter = std::min(width, depth);
  const double d = shorter > 0 && longer >= 2 * shorter ? shorter : longer;
  return std::min(0.2 * std::pow(5, std::log10(d)), 10.0);
}

MeasuringField grid(Point3 corner, Vec3 u, Vec3 v, double spacing) {
  const double width = double(length(u)), depth = double(length(v));
  const Vec3 normal = normalize_or(cross(u, v), Vec3(0));
  if (normal == Vec3(0)) throw Error(Code::bad_param, "grid", "its sides span no area");
  if (spacing <= 0) spacing = standard_spacing(width, depth);
  MeasuringField field;
  field.name = "grid";
  field.columns = cells(width, spacing), field.rows = cells(depth, spacing);
  const double count = double(field.columns) * field.rows;
  check_count(count);
  field.corner = corner, field.u = u / float(field.columns), field.v = v / float(field.rows);
  const double area = double(length(cross(u, v))) / count;
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column)
      field.points.push_back(corner + (float(column) + 0.5f) * field.u + (float(row) + 0.5f) * field.v);
  field.normals.assign(field.points.size(), normal);
  field.areas.assign(field.points.size(), area);
  return field;
}

MeasuringField work_plane(const Scene& scene, double height, double margin, double spacing) {
  const Bounds box = bounds(scene);
  if (box.empty()) throw Error(Code::bad_param, "plane", "the scene is empty");
  const Vec3 size = box.size();
  const float m = margin < 0 ? std::min(0.5f, 0.15f * std::min(size.x, size.z)) : float(margin);
  const float y = box.low.y + float(height);
  if (!(size.x > 2 * m && size.z > 2 * m))
    throw Error(Code::bad_param, "margin", fmt::format("leaves nothing of {:.3g} m x {:.3g} m", size.x, size.z));
  if (!(y < box.high.y))
    throw Error(Code::bad_param, "plane", fmt::format("lies above the scene, which is {:.3g} m high", size.y));
  MeasuringField field =
      grid({box.low.x + m, y, box.high.z - m}, {size.x - 2 * m, 0, 0}, {0, 0, 2 * m - size.z}, spacing);
  field.name = "work plane";
  return field;
}

MeasuringField surface(const Scene& scene, std::string_view name, double spacing) {
  WorldTriangles triangles;
  const TessellatedScene tessellated(scene);
  for (const Instance& instance : tessellated->instances)
    if (named(*tessellated, instance, name))
      triangles.add(tessellated->meshes[size_t(instance.mesh)], instance.to_world);
  if (triangles.all.empty())
    throw Error(Code::bad_param, "surface", fmt::format("no node, mesh or material is called '{}'", name));
  const double side = std::sqrt(triangles.area);
  if (spacing <= 0) spacing = standard_spacing(side, side);
  MeasuringField field;
  field.name = name;
  for (const auto& [a, b, c] : triangles.all) add_triangle(field, a, b, c, spacing);
  if (field.points.empty()) throw Error(Code::bad_param, "surface", fmt::format("'{}' has no area", name));
  return field;
}

}  // namespace aktina
