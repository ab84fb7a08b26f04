// Vertex normals of a whole mesh: which facets are one fan, and which vertices must be doubled.
#include <algorithm>
#include <cmath>

#include "aktina/scene/corners.h"
#include "aktina/scene/mesh.h"

namespace aktina {
namespace {

/// A corner of a triangle at the place in hand.
struct Corner {
  uint32_t id;              // 3 * triangle + corner
  uint32_t face;            // source polygon
  uint32_t next, previous;  // places that follow and precede it
  uint32_t fan;             // representative: index into the list of corners
  Vec3d normal;             // of its face: unit, or 0
};

/// An edge that leaves (or enters) the place in hand.
struct Spoke {
  uint32_t other;   // place at the far end
  uint32_t corner;  // index into the list of corners
  bool leaves;
};

class NormalGenerator {
 public:
  NormalGenerator(Mesh& mesh, float crease, FacetWeighting weighting)
      : mesh_(mesh),
        weighting_(weighting),
        least_cosine_(std::cos(double(crease) + 1e-4)),
        meeting_(mesh.positions, mesh.triangles) {
    if (!mesh.triangle_face.empty()) sum_faces();
    mesh.normals.assign(mesh.positions.size(), Vec3(0, 1, 0));
    taken_.assign(mesh.positions.size(), false);
  }

  void run() {
    for (size_t place = 0; place < meeting_.places(); ++place) {
      load(meeting_.at(place));
      if (corners_.empty()) continue;
      join_fans();
      assign_normals();
    }
    append_doubled();
  }

 private:
  Vec3d edge(uint32_t t, uint32_t from, uint32_t to) const {
    const auto at = [&](uint32_t k) { return Vec3d(mesh_.positions[meeting_.place(mesh_.triangles[t][k])]); };
    return at(to) - at(from);
  }
  Vec3d normal_of_triangle(uint32_t t) const { return cross(edge(t, 0, 1), edge(t, 0, 2)); }
  uint32_t& vertex_of(uint32_t corner) { return mesh_.triangles[corner / 3][corner % 3]; }
  uint32_t place_of(uint32_t corner) { return meeting_.place(vertex_of(corner)); }
  static bool degenerate(const Corner& c) { return c.next == c.previous || c.normal == Vec3d(0); }

  /// Polygons of several triangles: the sum of theirs.
  void sum_faces() {
    face_normals_.assign(mesh_.faces(), Vec3d(0));
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) face_normals_[mesh_.face_of(t)] += normal_of_triangle(t);
  }

  void load(std::span<const uint32_t> corners) {
    corners_.clear();
    for (const uint32_t id : corners) {
      const uint32_t t = id / 3, k = id % 3, face = mesh_.face_of(t);
      const Vec3d n = face_normals_.empty() ? normal_of_triangle(t) : face_normals_[face];
      corners_.push_back({id, face, place_of(3 * t + (k + 1) % 3), place_of(3 * t + (k + 2) % 3),
                          uint32_t(corners_.size()), length(n) > 0 ? normalize(n) : Vec3d(0)});
    }
  }

  uint32_t fan_of(uint32_t corner) {
    while (corners_[corner].fan != corner) corner = corners_[corner].fan = corners_[corners_[corner].fan].fan;
    return corner;
  }

  /// Joins corners across edges that exactly two facets share, in opposite directions, without a crease.
  void join_fans() {
    spokes_.clear();
    for (uint32_t i = 0; i < corners_.size(); ++i) {
      if (degenerate(corners_[i])) continue;
      spokes_.push_back({corners_[i].next, i, true});
      spokes_.push_back({corners_[i].previous, i, false});
    }
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) { return a.other < b.other; });
    for (size_t i = 0, end = 0; i < spokes_.size(); i = end) {
      while (end < spokes_.size() && spokes_[end].other == spokes_[i].other) ++end;
      if (end - i == 2 && spokes_[i].leaves != spokes_[i + 1].leaves &&
          smooth(spokes_[i].corner, spokes_[i + 1].corner))
        corners_[fan_of(spokes_[i].corner)].fan = fan_of(spokes_[i + 1].corner);
    }
    for (uint32_t i = 0; i < corners_.size(); ++i) corners_[i].fan = fan_of(i);
  }
  bool smooth(uint32_t a, uint32_t b) const {
    return corners_[a].face == corners_[b].face || dot(corners_[a].normal, corners_[b].normal) >= least_cosine_;
  }

  void assign_normals() {
    std::sort(corners_.begin(), corners_.end(), [](const Corner& a, const Corner& b) {
      return a.fan != b.fan ? a.fan < b.fan : a.face != b.face ? a.face < b.face : a.id < b.id;
    });
    for (size_t i = 0, end = 0; i < corners_.size(); i = end) {
      while (end < corners_.size() && corners_[end].fan == corners_[i].fan) ++end;
      const std::span<Corner> fan(&corners_[i], end - i);
      give(fan, Vec3(normal_of(fan)));
    }
  }

  Vec3d normal_of(std::span<const Corner> fan) {
    const Vec3d flat = fan.front().normal;
    if (fan.front().face == fan.back().face) return flat == Vec3d(0) ? Vec3d(0, 1, 0) : flat;
    facets_.clear();
    for (size_t i = 0, end = 0; i < fan.size(); i = end) {
      while (end < fan.size() && fan[end].face == fan[i].face) ++end;
      add_facet(fan.subspan(i, end - i));
    }
    const Vec3d normal = vertex_normal(weighting_, facets_);
    return normal == Vec3d(0) ? flat : normal;
  }

  /// The triangles of one polygon at this vertex are one facet: its own two edges count, not the diagonals.
  void add_facet(std::span<const Corner> face) {
    const Corner *first = nullptr, *last = nullptr;
    if (face.size() <= kLargestPolygonFan)
      for (const Corner& c : face) {
        const auto follows = [&](const Corner& o) { return o.previous == c.next; };
        const auto precedes = [&](const Corner& o) { return o.next == c.previous; };
        if (std::none_of(face.begin(), face.end(), follows)) first = &c;
        if (std::none_of(face.begin(), face.end(), precedes)) last = &c;
      }
    if (first && last) {
      const FacetCorner whole{edge_to_next(*first), edge_to_previous(*last)};
      if (dot(cross(whole.next, whole.previous), first->normal) > 0) return facets_.push_back(whole);
    }
    for (const Corner& c : face) facets_.push_back({edge_to_next(c), edge_to_previous(c)});
  }
  Vec3d edge_to_next(const Corner& c) const { return edge(c.id / 3, c.id % 3, (c.id % 3 + 1) % 3); }
  Vec3d edge_to_previous(const Corner& c) const { return edge(c.id / 3, c.id % 3, (c.id % 3 + 2) % 3); }

  /// Writes a fan's normal to its vertices; a vertex that another fan has taken is doubled.
  void give(std::span<Corner> fan, Vec3 value) {
    std::sort(fan.begin(), fan.end(),
              [&](const Corner& a, const Corner& b) { return vertex_of(a.id) < vertex_of(b.id); });
    for (size_t i = 0, end = 0; i < fan.size(); i = end) {
      const uint32_t old = vertex_of(fan[i].id);
      while (end < fan.size() && vertex_of(fan[end].id) == old) ++end;
      const uint32_t vertex = taken_[old] ? doubled(old) : old;
      taken_[old] = true;
      normal(vertex) = value;
      for (size_t k = i; k < end; ++k) vertex_of(fan[k].id) = vertex;
    }
  }
  uint32_t doubled(uint32_t vertex) {
    meeting_.add_vertex_at(vertex);
    doubled_.push_back(vertex);
    doubled_normals_.push_back({});
    return uint32_t(mesh_.positions.size() + doubled_.size() - 1);
  }
  Vec3& normal(uint32_t vertex) {
    const size_t own = mesh_.normals.size();
    return vertex < own ? mesh_.normals[vertex] : doubled_normals_[vertex - own];
  }

  /// All doubled vertices at once: their number is known now.
  void append_doubled() {
    const auto again = [this](auto& list) {
      if (list.empty()) return;
      list.reserve(list.size() + doubled_.size());
      for (const uint32_t vertex : doubled_) list.push_back(list[vertex]);
    };
    again(mesh_.positions), again(mesh_.tangents), again(mesh_.uv[0]), again(mesh_.uv[1]), again(mesh_.colours);
    mesh_.normals.reserve(mesh_.normals.size() + doubled_.size());
    mesh_.normals.insert(mesh_.normals.end(), doubled_normals_.begin(), doubled_normals_.end());
  }

  static constexpr size_t kLargestPolygonFan = 64;  // triangles of one polygon at one vertex that are looked at as one

  Mesh& mesh_;
  FacetWeighting weighting_;
  double least_cosine_;
  CornersByPlace meeting_;
  std::vector<Vec3d> face_normals_;  // twice the area long; empty: each triangle is a face
  std::vector<bool> taken_;
  std::vector<uint32_t> doubled_;  // the vertices that others repeat
  std::vector<Vec3> doubled_normals_;
  std::vector<Corner> corners_;
  std::vector<Spoke> spokes_;
  std::vector<FacetCorner> facets_;
};

}  // namespace

void generate_normals(Mesh& mesh, float crease, FacetWeighting weighting) {
  if (mesh.normals.empty() && !mesh.positions.empty()) NormalGenerator(mesh, crease, weighting).run();
}

}  // namespace aktina
