#include "aktina/radiosity/formfactor/face.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr double kPlanar = 1e-6;  // of the polygon's size

Vec3d newell(std::span<const Point3d> vertices) {
  Vec3d n(0);
  for (size_t i = 1; i + 1 < vertices.size(); ++i) n += cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
  return 0.5 * n;
}

void bound(Face& face) {
  Point3d low = face.vertices[0], high = low;
  for (const Point3d& v : face.vertices) low = glm::min(low, v), high = glm::max(high, v);
  face.centre = 0.5 * low + 0.5 * high;
  face.radius = 0;
  for (const Point3d& v : face.vertices) face.radius = std::max(face.radius, length(v - face.centre));
}

/// Twice the signed area of a corner, seen from the front.
double turn(const Face& face, Point3d a, Point3d b, Point3d c) { return dot(face.plane.normal, cross(b - a, c - b)); }

bool inside_triangle(const Face& face, Point3d p, Point3d a, Point3d b, Point3d c) {
  return turn(face, a, b, p) >= 0 && turn(face, b, c, p) >= 0 && turn(face, c, a, p) >= 0;
}

bool is_convex(const Face& face) {
  const Contour& v = face.vertices;
  const size_t n = v.size();
  double angle = 0;  // once around: a pentagram turns left everywhere too
  for (size_t i = 0; i < n; ++i) {
    const Vec3d e = v[(i + 1) % n] - v[i], f = v[(i + 2) % n] - v[(i + 1) % n];
    const double sine = dot(face.plane.normal, cross(e, f));
    if (sine < -1e-12 * (squared_length(e) + squared_length(f))) return false;
    angle += std::atan2(sine, dot(e, f));
  }
  return angle < 3 * kPi;
}

bool is_ear(const Face& face, const Contour& rest, size_t i) {
  const size_t n = rest.size();
  const Point3d a = rest[(i + n - 1) % n], b = rest[i], c = rest[(i + 1) % n];
  if (!(turn(face, a, b, c) > 0)) return false;
  return std::none_of(rest.begin(), rest.end(), [&](const Point3d& p) {
    return p != a && p != b && p != c && inside_triangle(face, p, a, b, c);
  });
}

/// Triangles by cutting ears; what is left where a polygon crosses itself is cut as a fan.
/// G. Meisters, "Polygons Have Ears", American Mathematical Monthly 82, 1975.
std::vector<Contour> triangles(const Face& face) {
  std::vector<Contour> pieces;
  Contour rest = face.vertices;
  while (rest.size() > 3) {
    const size_t n = rest.size();
    size_t ear = 0, flat = n;
    while (ear < n && !is_ear(face, rest, ear)) {
      if (turn(face, rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]) == 0) flat = ear;
      ++ear;
    }
    if (ear == n && flat == n) ear = 1;
    if (ear < n) pieces.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + std::ptrdiff_t(ear < n ? ear : flat));
  }
  pieces.push_back(rest);
  return pieces;
}

/// Distance in the plane of the face from a point of that plane to the face: 0 inside.
double distance_in_plane(const Face& face, Point3d p) {
  for (const Contour& piece : face.convex) {
    bool inside = true;
    for (size_t i = 0; i < piece.size(); ++i)
      inside = inside && turn(face, piece[i], piece[(i + 1) % piece.size()], p) >= 0;
    if (inside) return 0;
  }
  double nearest = INFINITY;
  for (size_t i = 0; i < face.vertices.size(); ++i) {
    const Point3d a = face.vertices[i], e = face.vertices[(i + 1) % face.vertices.size()] - a;
    const double squared = squared_length(e), t = squared > 0 ? std::clamp(dot(p - a, e) / squared, 0.0, 1.0) : 0;
    nearest = std::min(nearest, length(a + t * e - p));
  }
  return nearest;
}

}  // namespace

Vec3d newell_normal(const Polygon& polygon) { return polygon.vertices.empty() ? Vec3d(0) : newell(polygon.vertices); }

Face make_face(const Polygon& polygon, const std::string& where) {
  Face face;
  face.vertices = polygon.vertices;
  if (face.vertices.size() < 3)
    throw Error(Code::bad_input, where, fmt::format("has {} vertices", face.vertices.size()), "three or more");
  for (const Point3d& v : face.vertices)
    if (!std::isfinite(squared_length(v))) throw Error(Code::bad_input, where, "has a vertex that is not finite");
  bound(face);
  const Vec3d normal = newell(face.vertices);
  face.area = length(normal);
  if (!std::isfinite(face.area)) throw Error(Code::bad_input, where, "is too large: its area is not finite");
  // A needle's area loses its digits where its height is lost in the rounding of its coordinates.
  if (!(face.area > 1e-15 * face.radius * (face.radius + length(face.centre))))
    throw Error(Code::bad_input, where, "has no area");
  face.plane = {face.centre, normal / face.area};
  double mean = 0, most = 0;
  for (const Point3d& v : face.vertices) mean += face.plane.height(v) / double(face.vertices.size());
  face.plane.point += mean * face.plane.normal;
  for (const Point3d& v : face.vertices) most = std::max(most, std::abs(face.plane.height(v)));
  if (most > kPlanar * face.radius + 1e-12 * length(face.centre))
    throw Error(Code::bad_input, where, fmt::format("is not planar: a vertex is {:.3g} m off its plane", most),
                "cut it into triangles");
  face.convex = is_convex(face) ? std::vector<Contour>{face.vertices} : triangles(face);
  return face;
}

Contour clip(std::span<const Point3d> contour, const Plane& plane, double margin) {
  thread_local std::vector<double> heights;
  heights.resize(contour.size());
  double highest = 0, lowest = 0;
  for (size_t i = 0; i < contour.size(); ++i) {
    const double h = plane.height(contour[i]);
    heights[i] = std::abs(h) <= margin ? 0 : h;
    highest = std::max(highest, heights[i]), lowest = std::min(lowest, heights[i]);
  }
  if (highest == 0) return {};
  if (lowest == 0) return {contour.begin(), contour.end()};
  Contour kept;
  kept.reserve(contour.size() + 2);
  for (size_t i = 0; i < contour.size(); ++i) {
    const size_t next = i + 1 < contour.size() ? i + 1 : 0;
    const double a = heights[i], b = heights[next];
    if (a >= 0) kept.push_back(contour[i]);
    if (a * b < 0) {
      // From the front end always, so that neighbours who share the edge get the same point.
      const bool leaves = a > 0;
      const Point3d front = contour[leaves ? i : next], back = contour[leaves ? next : i];
      const double t = leaves ? a / (a - b) : b / (b - a);
      kept.push_back(front + t * (back - front));
    }
  }
  return kept;
}

double distance(const Face& face, Point3d x) {
  const double h = face.plane.height(x);
  return std::hypot(h, distance_in_plane(face, x - h * face.plane.normal));
}

}  // namespace aktina
