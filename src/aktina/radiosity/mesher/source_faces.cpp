#include "aktina/radiosity/mesher/source_faces.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr float kParallelogram = 1e-4f;  // relative: triangles that are nobody's polygon join to parallelograms only
constexpr float kPlanar = 1e-6f;         // 1 - cosine
constexpr float kRounding = 0x1p-22f;    // of coordinates: what the sum of four of them may be off by

Vec3 cross_of(const std::vector<Point3>& p, const std::array<uint32_t, 3>& t) {
  return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

bool has_area(const std::vector<Point3>& p, const std::array<uint32_t, 3>& t) {
  const Vec3d a(p[t[0]]), ab = Vec3d(p[t[1]]) - a, ac = Vec3d(p[t[2]]) - a, bc = ac - ab;
  const double longest = std::max({squared_length(ab), squared_length(ac), squared_length(bc)});
  return std::isfinite(longest) && length(cross(ab, ac)) > 1e-7 * longest;
}

float max_coordinate(Point3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

bool convex(const std::vector<Point3>& p, const std::array<uint32_t, 4>& q, Vec3 normal) {
  for (size_t i = 0; i < 4; ++i) {
    const Vec3 in = p[q[(i + 1) % 4]] - p[q[i]], out = p[q[(i + 2) % 4]] - p[q[(i + 1) % 4]];
    if (!(dot(cross(in, out), normal) > 1e-3f * length(in) * length(out))) return false;
  }
  return true;
}

template <class T>
T blend(const std::array<uint32_t, 3>& t, const std::vector<T>& values, const SurfacePoint& at) {
  return values[t[0]] * (1 - at.u - at.v) + values[t[1]] * at.u + values[t[2]] * at.v;
}

}  // namespace

SourceFaces::SourceFaces(const Scene& scene, uint32_t instance)
    : mesh_(scene.meshes[size_t(scene.instances[instance].mesh)]),
      instance_(instance),
      to_world_(scene.instances[instance].to_world),
      normal_matrix_(glm::transpose(glm::inverse(Mat3(to_world_)))),
      mirrored_(glm::determinant(Mat3(to_world_)) < 0) {
  constexpr uint32_t kUnused = 0xffffffff;
  if (mesh_.normals.empty()) {  // as glTF asks: flat
    flat_.positions = mesh_.positions, flat_.triangles = mesh_.triangles;
    flat_.triangle_face = mesh_.triangle_face, flat_.face_count = mesh_.face_count;
    generate_normals(flat_, 0);
  }
  const std::vector<Point3>& sources = flat_.positions.empty() ? mesh_.positions : flat_.positions;
  const auto& triangles = flat_.positions.empty() ? mesh_.triangles : flat_.triangles;
  std::vector<uint32_t> id(sources.size(), kUnused);
  std::vector<Corners> corners(triangles.size());
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (size_t k = 0; k < 3; ++k) {
      uint32_t& vertex = id[triangles[t][k]];
      if (vertex == kUnused) {
        vertex = uint32_t(positions.size());
        positions.push_back(transform_point(to_world_, sources[triangles[t][k]]));
      }
      corners[t].ids[k] = vertex;
    }
    if (mirrored_) std::swap(corners[t].ids[1], corners[t].ids[2]);
    corners[t].usable = has_area(positions, corners[t].ids);
    degenerate += !corners[t].usable;
  }
  add_faces(corners);
}

void SourceFaces::add_faces(const std::vector<Corners>& corners) {
  for (uint32_t t = 0; t < corners.size(); ++t) {
    const Corners& a = corners[t];
    if (!a.usable) continue;
    if (t + 1 < corners.size() && corners[t + 1].usable && join(t, a, corners[t + 1])) {
      ++t;
      continue;
    }
    list.push_back({{a.ids[0], a.ids[1], a.ids[2], a.ids[2]}, {t, t}});
  }
}

/// Triangles `first` and the next one as a quadrilateral, if they are one.
bool SourceFaces::join(uint32_t first, const Corners& a, const Corners& b) {
  const bool stated = !mesh_.triangle_face.empty();
  if (stated && mesh_.triangle_face[first] != mesh_.triangle_face[first + 1]) return false;
  const Vec3 na = cross_of(positions, a.ids), nb = cross_of(positions, b.ids);
  if (!(dot(na, nb) > (1 - kPlanar) * length(na) * length(nb))) return false;
  for (size_t i = 0; i < 3; ++i)
    for (size_t k = 0; k < 3; ++k) {
      if (a.ids[i] != b.ids[(k + 1) % 3] || a.ids[(i + 1) % 3] != b.ids[k]) continue;
      const std::array<uint32_t, 4> quad = {a.ids[(i + 2) % 3], a.ids[i], b.ids[(k + 2) % 3], a.ids[(i + 1) % 3]};
      const Vec3 gap = positions[quad[0]] - positions[quad[1]] + positions[quad[2]] - positions[quad[3]];
      const float size = length(positions[quad[0]] - positions[quad[2]]);
      const float most = kParallelogram * size + kRounding * max_coordinate(positions[quad[0]]);
      if ((!stated && length(gap) > most) || !convex(positions, quad, na / length(na))) return false;
      list.push_back({quad, {first, first + 1}});
      return true;
    }
  return false;
}

SurfacePoint SourceFaces::place(const SourceFace& face, Point3 point) const {
  SurfacePoint best;
  double inside = -1e30;
  for (const uint32_t t : face.triangles) {
    const auto& v = mesh_.triangles[t];
    Vec3d p[3];
    for (size_t k = 0; k < 3; ++k) p[k] = transform_point(to_world_, mesh_.positions[v[k]]);
    const Vec3d ab = p[1] - p[0], ac = p[2] - p[0], at = Vec3d(point) - p[0];
    const double bb = dot(ab, ab), bc = dot(ab, ac), cc = dot(ac, ac), pb = dot(at, ab), pc = dot(at, ac);
    const double det = bb * cc - bc * bc, u = (cc * pb - bc * pc) / det, w = (bb * pc - bc * pb) / det;
    const double least = std::min({u, w, 1 - u - w});
    if (!(least > inside)) continue;
    inside = least;
    const double cu = std::clamp(u, 0.0, 1.0);
    best = {instance_, t, float(cu), float(std::clamp(w, 0.0, 1 - cu))};
  }
  return best;
}

Vec3 SourceFaces::normal(const SurfacePoint& at) const {
  const Mesh& source = flat_.positions.empty() ? mesh_ : flat_;
  const auto& t = source.triangles[at.triangle];
  const Vec3 face = cross_of(source.positions, t);
  return normalize_or(normal_matrix_ * blend(t, source.normals, at), normalize_or(normal_matrix_ * face, {0, 1, 0}));
}

Vec2 SourceFaces::uv(const SurfacePoint& at, int set) const {
  return mesh_.uv[set].empty() ? Vec2(0) : blend(mesh_.triangles[at.triangle], mesh_.uv[set], at);
}

Vec4 SourceFaces::colour(const SurfacePoint& at) const {
  return mesh_.colours.empty() ? Vec4(1) : blend(mesh_.triangles[at.triangle], mesh_.colours, at);
}

}  // namespace aktina
