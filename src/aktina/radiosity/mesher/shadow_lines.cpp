#include "aktina/radiosity/mesher/shadow_lines.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

/// The part of a polygon with dot(normal, p) <= offset.
FacePolygon behind(const FacePolygon& polygon, Vec3d normal, double offset) {
  FacePolygon part;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Point3d p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    const double dp = dot(normal, p) - offset, dq = dot(normal, q) - offset;
    if (dp <= 0) part.push_back(p);
    if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) part.push_back(p + (q - p) * (dp / (dp - dq)));
  }
  return part.size() >= 3 ? part : FacePolygon();
}

void range(const FacePolygon& points, Vec3d normal, double offset, double& low, double& high) {
  low = 1e300, high = -1e300;
  for (const Point3d p : points)
    low = std::min(low, dot(normal, p) - offset), high = std::max(high, dot(normal, p) - offset);
}

/// Adds the plane through an edge and a corner, turned so that the occluder is behind it, if the light is wholly on the
/// side that is asked for.
void add_plane(Point3d a, Point3d b, Point3d corner, const FacePolygon& occluder, const FacePolygon& light,
               bool penumbra, double tolerance, ShadowVolume& volume) {
  Vec3d normal = cross(b - a, corner - a);
  const double scale = length(normal);
  if (!(scale > tolerance * length(b - a))) return;
  normal /= scale;
  double low, high;
  range(occluder, normal, dot(normal, a), low, high);
  if (low < -tolerance && high > tolerance) return;
  if (high > tolerance) normal = -normal;
  range(light, normal, dot(normal, a), low, high);
  if (light.size() > 1 && (penumbra ? low < -tolerance : high > tolerance)) return;
  volume.planes.push_back({normal, dot(normal, a)});
}

/// Pieces of [0, 1] that none of the intervals covers.
template <class Body>
void each_gap(std::vector<std::pair<double, double>>& covered, const Body& body) {
  std::sort(covered.begin(), covered.end());
  double at = 0;
  for (const auto& [from, to] : covered) {
    if (from > at) body(at, from);
    at = std::max(at, to);
  }
  if (at < 1) body(at, 1.0);
}

/// Edges of polygons in the plane of a face, as far as they bound the union of all.
void add_outline(const std::vector<FacePolygon>& shadows, const FlatFace& face, uint32_t index, double shortest,
                 double tolerance, std::vector<Contact>& lines) {
  std::vector<std::pair<double, double>> covered;
  for (const FacePolygon& shadow : shadows)
    for (size_t k = 0; k < shadow.size(); ++k) {
      const Point3d a = shadow[k], b = shadow[(k + 1) % shadow.size()];
      if (!(length(b - a) > tolerance)) continue;
      const Vec3d across = cross(face.normal, b - a) * (8 * tolerance / length(b - a));
      for (const Vec3d off : {across, -across}) {
        covered.clear();
        for (const FacePolygon& other : shadows) {
          double from, to;
          if (clip_segment(a + off, b + off, other, face.normal, tolerance, from, to)) covered.emplace_back(from, to);
        }
        each_gap(covered, [&](double from, double to) {
          double start, end;
          const Point3d p = a + (b - a) * from, q = a + (b - a) * to;
          if (length(q - p) >= shortest && clip_segment(p, q, face.corners, face.normal, tolerance, start, end))
            lines.push_back({index, p + (q - p) * start, p + (q - p) * end});
        });
      }
    }
}

struct Caster {
  uint32_t face;
  ShadowVolume penumbra, umbra;
};

std::vector<Caster> casters_of(const std::vector<FlatFace>& faces, const ShadowLight& light, double tolerance) {
  std::vector<Caster> casters;
  const bool point = light.corners.size() == 1;
  for (uint32_t i = 0; i < faces.size(); ++i) {
    if (i == light.face) continue;
    const FlatFace& f = faces[i];
    const FacePolygon lit =
        point ? f.corners  // in front of the light
              : behind(f.corners, -light.normal, -dot(light.normal, light.corners[0]) - 8 * tolerance);
    if (lit.empty()) continue;
    for (const double side : {1.0, -1.0}) {  // what of the light is on this side of the face
      FacePolygon part = light.corners;
      if (!point) part = behind(part, -side * f.normal, -side * f.offset - 8 * tolerance);
      if (part.empty() || (point && side * f.distance(part[0]) <= 8 * tolerance)) continue;
      Caster c{i, shadow_volume(lit, part, true, tolerance), {}};
      if (!point) c.umbra = shadow_volume(lit, part, false, tolerance);
      const ShadowVolume::Plane own{side * f.normal, side * f.offset - 8 * tolerance};
      c.penumbra.planes.push_back(own);
      if (!point) c.umbra.planes.push_back(own);
      casters.push_back(std::move(c));
    }
  }
  return casters;
}

FacePolygon within(FacePolygon polygon, const ShadowVolume& volume) {
  if (volume.planes.empty()) return {};
  for (const ShadowVolume::Plane& plane : volume.planes) {
    polygon = behind(polygon, plane.normal, plane.offset);
    if (polygon.empty()) break;
  }
  return polygon;
}

}  // namespace

ShadowVolume shadow_volume(const FacePolygon& occluder, const FacePolygon& light, bool penumbra, double tolerance) {
  ShadowVolume volume;
  for (size_t k = 0; k < occluder.size(); ++k)
    for (const Point3d corner : light)
      add_plane(occluder[k], occluder[(k + 1) % occluder.size()], corner, occluder, light, penumbra, tolerance, volume);
  if (penumbra && light.size() > 1)
    for (size_t k = 0; k < light.size(); ++k)
      for (const Point3d corner : occluder)
        add_plane(corner, corner + (light[(k + 1) % light.size()] - light[k]), light[k], occluder, light, penumbra,
                  tolerance, volume);
  return volume;
}

std::vector<Contact> shadow_lines(const std::vector<FlatFace>& faces, const ShadowLight& light, double shortest,
                                  double tolerance) {
  const std::vector<Caster> casters = casters_of(faces, light, tolerance);
  std::vector<std::vector<Contact>> found(faces.size());
  parallel_for(faces.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      std::vector<FacePolygon> penumbrae, umbrae;
      for (const Caster& c : casters) {
        if (c.face == i) continue;
        if (FacePolygon p = within(faces[i].corners, c.penumbra); !p.empty()) penumbrae.push_back(std::move(p));
        if (FacePolygon p = within(faces[i].corners, c.umbra); !p.empty()) umbrae.push_back(std::move(p));
      }
      add_outline(penumbrae, faces[i], uint32_t(i), shortest, tolerance, found[i]);
      add_outline(umbrae, faces[i], uint32_t(i), shortest, tolerance, found[i]);
    }
  });
  std::vector<Contact> lines;
  for (const auto& each : found) lines.insert(lines.end(), each.begin(), each.end());
  return lines;
}

}  // namespace aktina
