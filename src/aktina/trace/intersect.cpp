#include "aktina/trace/intersect.h"

#include <cmath>

namespace aktina {
namespace {

/// Newell's normal: the sum of the cross products of successive vertices, twice the area long.
Vec3d newell_normal(std::span<const Point3d> vertices) {
  Vec3d n(0);
  Point3d previous = vertices.back() - vertices.front();
  for (const Point3d& vertex : vertices) {
    const Point3d current = vertex - vertices.front();
    n += cross(previous, current);
    previous = current;
  }
  return n;
}

int largest_axis(Vec3d v) {
  const Vec3d a = glm::abs(v);
  return a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
}

/// Crossings of the polygon's edges with the ray from `p` towards +u, in the plane of axes u and v.
bool odd_crossings(std::span<const Point3d> vertices, Point3d p, int u, int v) {
  bool inside = false;
  Point3d a = vertices.back();
  for (const Point3d& b : vertices) {
    if ((a[v] > p[v]) != (b[v] > p[v]) && p[u] < (b[u] - a[u]) * (p[v] - a[v]) / (b[v] - a[v]) + a[u]) inside = !inside;
    a = b;
  }
  return inside;
}

}  // namespace

std::optional<SurfaceHit> intersect_plane(const Line& line, Vec3d normal, double d) {
  const double slope = dot(normal, line.direction), t = (d - dot(normal, line.origin)) / slope;
  if (slope == 0 || !line.contains(t)) return std::nullopt;
  return SurfaceHit{t, normalize(normal)};
}

std::optional<SurfaceHit> intersect_triangle(const Line& line, Point3d a, Point3d b, Point3d c) {
  const Vec3d ab = b - a, ac = c - a, p = cross(line.direction, ac), s = line.origin - a, q = cross(s, ab);
  const double determinant = dot(ab, p);
  if (determinant == 0) return std::nullopt;
  const double u = dot(s, p) / determinant, v = dot(line.direction, q) / determinant, t = dot(ac, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && line.contains(t))) return std::nullopt;
  return SurfaceHit{t, normalize(cross(ab, ac)), u, v};
}

std::optional<SurfaceHit> intersect_polygon(const Line& line, std::span<const Point3d> vertices) {
  if (vertices.size() < 3) return std::nullopt;
  const Vec3d n = newell_normal(vertices);
  Line local = line;
  local.origin -= vertices.front();
  const auto hit = intersect_plane(local, n, 0);
  if (!hit) return std::nullopt;
  const int drop = largest_axis(n);
  if (!odd_crossings(vertices, line.at(hit->t), (drop + 1) % 3, (drop + 2) % 3)) return std::nullopt;
  return hit;
}

}  // namespace aktina
