#include "aktina/trace/placed_primitive.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

/// An ellipse that is the image of the circle of radius r about +y at height y reaches r sqrt(Mx0^2 + Mx2^2) along x.
void add_circle(Bounds& box, const Mat4& m, float radius, float y) {
  const Point3 centre = transform_point(m, {0, y, 0});
  Vec3 reach;
  for (int k = 0; k < 3; ++k) reach[k] = std::abs(radius) * std::hypot(m[0][k], m[2][k]);
  box.add(centre - reach), box.add(centre + reach);
}

void add(Bounds& box, const Mat4& m, const Sphere& s) {
  const Point3 centre = transform_point(m, Point3(0));
  Vec3 reach;
  for (int k = 0; k < 3; ++k) reach[k] = std::abs(s.radius) * std::hypot(m[0][k], m[1][k], m[2][k]);
  box.add(centre - reach), box.add(centre + reach);
}
void add(Bounds& box, const Mat4& m, const Disc& d) { add_circle(box, m, d.radius, 0); }
void add(Bounds& box, const Mat4& m, const Cylinder& c) {
  add_circle(box, m, c.radius, 0), add_circle(box, m, c.radius, c.height);
}
void add(Bounds& box, const Mat4& m, const Cone& c) {
  add_circle(box, m, c.radius, 0), add_circle(box, m, c.top_radius, c.height);
}

float around(Point3 p) { return std::atan2(p.x, -p.z) * float(0.5 * kInvPi) + 0.5f; }

Vec2 uv(const Sphere& s, Point3 p) {
  const float c = s.radius > 0 ? std::clamp(p.y / s.radius, -1.0f, 1.0f) : 1;
  return {around(p), std::acos(c) * float(kInvPi)};
}
Vec2 uv(const Disc& d, Point3 p) {
  return {around(p), d.radius > 0 ? std::min(std::hypot(p.x, p.z) / d.radius, 1.0f) : 0};
}
Vec2 uv_by_height(float height, Point3 p) {
  return {around(p), height > 0 ? std::clamp(1 - p.y / height, 0.0f, 1.0f) : 0};
}
Vec2 uv(const Cylinder& c, Point3 p) { return uv_by_height(c.height, p); }
Vec2 uv(const Cone& c, Point3 p) { return uv_by_height(c.height, p); }

/// Moves p across the axis to the given distance from it.
Point3d at_radius(Point3d p, double radius) {
  const double r = std::hypot(p.x, p.z), scale = r > 0 ? radius / r : 0;
  return {p.x * scale, p.y, p.z * scale};
}

Point3d snap(const Sphere& s, Point3d p) {
  const double r = length(p);
  return r > 0 ? p * (double(std::abs(s.radius)) / r) : p;
}
Point3d snap(const Disc& /*disc*/, Point3d p) { return {p.x, 0, p.z}; }
Point3d snap(const Cylinder& c, Point3d p) { return at_radius(p, double(c.radius)); }
Point3d snap(const Cone& c, Point3d p) {
  const double h = double(c.height), t = h > 0 ? std::clamp(p.y / h, 0.0, 1.0) : 0;
  return at_radius(p, double(c.radius) + (double(c.top_radius) - double(c.radius)) * t);
}

}  // namespace

PlacedPrimitive::PlacedPrimitive(const Primitive& shape, const Mat4& to_world)
    : shape_(&shape), to_world_(to_world), to_local_(glm::inverse(Mat4d(to_world))) {}

Bounds PlacedPrimitive::bounds() const {
  Bounds box;
  std::visit([&](const auto& shape) { add(box, to_world_, shape); }, *shape_);
  const Vec3 margin = 1e-6f * glm::max(glm::abs(box.low), glm::abs(box.high));  // rounding of the sums above
  return {box.low - margin, box.high + margin};
}

std::optional<Hit> PlacedPrimitive::intersect(const Ray& ray) const {
  const Line line = {Vec3d(to_local_ * glm::dvec4(Vec3d(ray.origin), 1)),
                     Vec3d(to_local_ * glm::dvec4(Vec3d(ray.direction), 0)), double(ray.near), double(ray.far)};
  const auto found = aktina::intersect(*shape_, line);
  if (!found) return std::nullopt;
  Hit hit;
  hit.distance = float(found->t);
  hit.normal = Vec3(glm::transpose(glm::dmat3(to_local_)) * found->normal);
  return hit;
}

Point3 PlacedPrimitive::snap(Point3 world) const {
  const Point3d local = Vec3d(to_local_ * glm::dvec4(Vec3d(world), 1));
  const Point3d there = std::visit([&](const auto& shape) { return aktina::snap(shape, local); }, *shape_);
  return Vec3(Mat4d(to_world_) * glm::dvec4(there, 1));
}

Vec2 PlacedPrimitive::uv(Point3 world) const {
  const Point3 p = Vec3(to_local_ * glm::dvec4(Vec3d(world), 1));
  return std::visit([&](const auto& shape) { return aktina::uv(shape, p); }, *shape_);
}

}  // namespace aktina
