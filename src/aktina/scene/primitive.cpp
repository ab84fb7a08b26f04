#include "aktina/scene/primitive.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr int kFewestSegments = 8, kMostSegments = 1024;

/// Chords of a circle whose sagitta r (1 - cos(pi / n)) stays below the tolerance.
int segments(double radius, double tolerance) {
  if (!(radius > 0) || !(tolerance > 0)) return tolerance > 0 ? kFewestSegments : kMostSegments;
  const double half = std::acos(std::clamp(1 - tolerance / radius, -1.0, 1.0));
  return std::clamp(int(std::ceil(kPi / std::max(half, 1e-9))), kFewestSegments, kMostSegments);
}

/// A surface of revolution about y. A row has a vertex a column, and one more that repeats the first with u = 1; a pole
/// has one for each triangle that ends there.
class Revolution {
 public:
  explicit Revolution(int columns) : columns_(columns) {}

  /// Next row, from high y to low y; normal in the half plane (radial, y).
  void add_row(float radius, float y, Vec2 normal, float v) {
    const bool pole = radius == 0;
    const auto first = uint32_t(mesh_.positions.size());
    for (int i = 0; i <= columns_ - int(pole); ++i) {
      const double phi = 2 * kPi * double(i % columns_) / double(columns_);
      const auto c = float(std::cos(phi)), s = float(std::sin(phi));
      mesh_.positions.push_back({radius * s, y, radius * c});
      mesh_.normals.push_back({normal.x * s, normal.y, normal.x * c});
      mesh_.uv[0].push_back({(float(i) + (pole ? 0.5f : 0)) / float(columns_), v});
    }
    if (first > 0)
      for (int i = 0; i < columns_; ++i) add_quad(above_ + uint32_t(i), first + uint32_t(i), pole);
    above_ = first, above_is_pole_ = pole;
  }

  Mesh finish() { return std::move(mesh_); }

 private:
  void add_quad(uint32_t upper, uint32_t lower, bool lower_is_pole) {
    const uint32_t face = mesh_.face_count++;
    if (!lower_is_pole) add({upper, lower, lower + 1}, face);
    if (!above_is_pole_) add({upper, lower_is_pole ? lower : lower + 1, upper + 1}, face);
  }
  void add(std::array<uint32_t, 3> triangle, uint32_t face) {
    mesh_.triangles.push_back(triangle);
    mesh_.triangle_face.push_back(face);
  }

  int columns_;
  uint32_t above_ = 0;
  bool above_is_pole_ = false;
  Mesh mesh_;
};

Mesh tessellated(const Sphere& sphere, double tolerance) {
  const int columns = (segments(sphere.radius, tolerance / 2) + 1) / 2 * 2, rows = columns / 2;
  Revolution surface(columns);
  for (int row = 0; row <= rows; ++row) {
    const double theta = kPi * double(row) / double(rows);
    const bool pole = row == 0 || row == rows;
    const float sine = pole ? 0 : float(std::sin(theta)), cosine = float(std::cos(theta));
    surface.add_row(sphere.radius * sine, sphere.radius * cosine, {sine, cosine}, float(row) / float(rows));
  }
  return surface.finish();
}

Mesh tessellated(const Disc& disc, double tolerance) {
  Revolution surface(segments(disc.radius, tolerance));
  surface.add_row(0, 0, {0, 1}, 0);
  surface.add_row(disc.radius, 0, {0, 1}, 1);
  return surface.finish();
}

Mesh tessellated(const Cone& cone, double tolerance) {
  Revolution surface(segments(std::max(cone.radius, cone.top_radius), tolerance));
  const Vec2 slope{cone.height, cone.radius - cone.top_radius};
  const float slant = length(slope);
  const Vec2 normal = slant > 0 ? slope / slant : Vec2(1, 0);
  surface.add_row(cone.top_radius, cone.height, normal, 0);
  surface.add_row(cone.radius, 0, normal, 1);
  return surface.finish();
}

Mesh tessellated(const Cylinder& cylinder, double tolerance) {
  return tessellated(Cone{cylinder.radius, cylinder.radius, cylinder.height}, tolerance);
}

Bounds box(float radius, float low, float high) {
  Bounds b;
  b.add({-radius, low, -radius});
  b.add({radius, high, radius});
  return b;
}

double lateral_area(const Cone& c) {
  return kPi * (double(c.radius) + double(c.top_radius)) *
         std::hypot(double(c.radius) - double(c.top_radius), double(c.height));
}

struct BoundsOf {
  Bounds operator()(const Sphere& s) const { return box(s.radius, -s.radius, s.radius); }
  Bounds operator()(const Disc& d) const { return box(d.radius, 0, 0); }
  Bounds operator()(const Cylinder& c) const { return box(c.radius, 0, c.height); }
  Bounds operator()(const Cone& c) const { return box(std::max(c.radius, c.top_radius), 0, c.height); }
};

struct AreaOf {
  double operator()(const Sphere& s) const { return 4 * kPi * double(s.radius) * double(s.radius); }
  double operator()(const Disc& d) const { return kPi * double(d.radius) * double(d.radius); }
  double operator()(const Cylinder& c) const { return 2 * kPi * double(c.radius) * double(c.height); }
  double operator()(const Cone& c) const { return lateral_area(c); }
};

}  // namespace

Bounds bounds(const Primitive& primitive) { return std::visit(BoundsOf{}, primitive); }
double area(const Primitive& primitive) { return std::visit(AreaOf{}, primitive); }

Mesh tessellate(const Primitive& primitive, float tolerance) {
  return std::visit([&](const auto& shape) { return tessellated(shape, double(tolerance)); }, primitive);
}

}  // namespace aktina
