#include "aktina/radiosity/mesher/flat_face.h"

#include <map>
#include <tuple>
#include <unordered_map>

#include "aktina/radiosity/mesher/junctions.h"

namespace aktina {
namespace {

/// Places of vertices; what is nearer to one than the tolerance becomes it.
class Places {
 public:
  Places(const SceneFaces& faces, double tolerance) : cell_(2 * tolerance), tolerance_(tolerance) {
    for (const SourceFaces& each : faces.faces)
      for (const Point3 p : each.positions) add(p);
  }
  Point3 place(Point3d p) {
    const glm::i64vec3 low(glm::floor((p - tolerance_) / cell_)), high(glm::floor((p + tolerance_) / cell_));
    for (int64_t z = low.z; z <= high.z; ++z)
      for (int64_t y = low.y; y <= high.y; ++y)
        for (int64_t x = low.x; x <= high.x; ++x)
          if (const auto at = points_.find(key({x, y, z})); at != points_.end())
            for (const Point3 known : at->second)
              if (length(Point3d(known) - p) <= tolerance_) return known;
    add(Point3(p));
    return Point3(p);
  }

 private:
  void add(Point3 p) { points_[key(glm::i64vec3(glm::floor(Point3d(p) / cell_)))].push_back(p); }
  static uint64_t key(glm::i64vec3 c) {
    return uint64_t(c.x) * 0x9e3779b97f4a7c15ULL ^ uint64_t(c.y) * 0xc2b2ae3d27d4eb4fULL ^
           uint64_t(c.z) * 0x165667b19e3779f9ULL;
  }
  double cell_, tolerance_;
  std::unordered_map<uint64_t, std::vector<Point3>> points_;
};

/// Vertices of the parts of one face, added to its instance's.
class PartVertices {
 public:
  PartVertices(SourceFaces& faces, const SourceFace& whole, Places& places) : faces_(faces), places_(places) {
    for (const uint32_t corner : whole.corners) ids_.emplace(as_key(faces.positions[corner]), corner);
  }
  uint32_t at(Point3d p) {
    const Point3 place = places_.place(p);
    const auto [entry, is_new] = ids_.emplace(as_key(place), uint32_t(faces_.positions.size()));
    if (is_new) faces_.positions.push_back(place);
    return entry->second;
  }

 private:
  using Key = std::tuple<float, float, float>;
  static Key as_key(Point3 p) { return {p.x, p.y, p.z}; }
  SourceFaces& faces_;
  Places& places_;
  std::map<Key, uint32_t> ids_;
};

void add_part(const FacePolygon& part, const SourceFace& whole, PartVertices& vertices, std::vector<SourceFace>& list) {
  std::vector<uint32_t> ids;
  for (const Point3d p : part)
    if (const uint32_t id = vertices.at(p); ids.empty() || (id != ids.back() && id != ids.front())) ids.push_back(id);
  if (ids.size() < 3) return;
  list.push_back({{ids[0], ids[1], ids[2], ids.size() > 3 ? ids[3] : ids[2]}, whole.triangles});
}

}  // namespace

FlatFace flat_face(const SceneFaces& faces, uint32_t instance, uint32_t face) {
  const SourceFaces& of = faces.faces[instance];
  const SourceFace& f = of.list[face];
  FlatFace flat{instance, face, {}, {}, 0, {}};
  for (size_t k = 0; k < (f.is_quad() ? 4U : 3U); ++k) {
    flat.corners.emplace_back(of.positions[f.corners[k]]);
    flat.box.add(of.positions[f.corners[k]]);
  }
  const auto& c = flat.corners;
  flat.normal = normalize(f.is_quad() ? cross(c[2] - c[0], c[3] - c[1]) : cross(c[1] - c[0], c[2] - c[0]));
  Point3d middle(0);
  for (const Point3d p : c) middle += p / double(c.size());
  flat.offset = dot(flat.normal, middle);
  return flat;
}

std::vector<FlatFace> flat_faces(const SceneFaces& faces) {
  std::vector<FlatFace> all;
  for (uint32_t i = 0; i < faces.faces.size(); ++i)
    for (uint32_t k = 0; k < faces.faces[i].list.size(); ++k) all.push_back(flat_face(faces, i, k));
  return all;
}

Bounds bounds(const SceneFaces& faces) {
  Bounds box;
  for (const SourceFaces& each : faces.faces)
    for (const Point3 p : each.positions)
      if (is_finite(p)) box.add(p);
  return box;
}

void replace_faces(SceneFaces& faces, const std::vector<FaceParts>& cut) {
  if (cut.empty()) return;
  Places places(faces, double(kJunctionTolerance * bounds(faces).diagonal()));
  size_t next = 0;
  for (uint32_t i = 0; i < faces.faces.size(); ++i) {
    if (next == cut.size() || cut[next].instance != i) continue;
    SourceFaces& of = faces.faces[i];
    std::vector<SourceFace> list;
    for (uint32_t k = 0; k < of.list.size(); ++k) {
      if (next == cut.size() || cut[next].instance != i || cut[next].face != k) {
        list.push_back(of.list[k]);
        continue;
      }
      PartVertices vertices(of, of.list[k], places);
      for (const FacePolygon& part : cut[next++].parts) add_part(part, of.list[k], vertices, list);
    }
    of.list = std::move(list);
  }
}

}  // namespace aktina
