// A planar face with vertices along its edges -> patches that keep these vertices and add none there: a grid of
// quadrilaterals where opposite sides allow it; else straight cuts, rows peeled off along uneven sides, and triangles.
#pragma once

#include <unordered_map>

#include "aktina/radiosity/mesher/junctions.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/mesher/patch_builder.h"

namespace aktina {

/// Longest edges, m, of patches and of what shoots light as one.
struct PatchSizes {
  double patch, shooter;
};

/// All faces cut into patches no longer than asked for: no T-junctions, no cracks. Every edge is cut at the vertices of
/// others that lie on it, then into equal pieces by its length alone, so that neighbours agree without being asked.
/// @throws Error limit: more patches than `most`
PatchMesh subdivide(const Scene& scene, const SceneFaces& faces, PatchSizes sizes, uint64_t most, Warnings& warnings);

/// Of the faces of one instance.
class Subdivision {
 public:
  Subdivision(PatchMesh& mesh, PatchBuilder& builder, PatchSizes sizes, const Junctions& junctions);
  void add(uint32_t instance, const SourceFaces& faces);

 private:
  using Corners = PatchBuilder::Corners;
  /// A run of vertices in pool_, read in either direction.
  struct Side {
    int first, last;
    size_t pieces() const { return size_t(last < first ? first - last : last - first); }
    int at(size_t k) const { return last < first ? first - int(k) : first + int(k); }
    Side part(size_t from, size_t to) const { return {at(from), at(to)}; }
    Side reversed() const { return {last, first}; }
  };
  /// A convex polygon of three or four sides, counter-clockwise; each begins where the last one ends.
  struct Region {
    std::array<Side, 4> sides;
    size_t count;
    size_t pieces(size_t k) const { return sides[k].pieces(); }
    Region turned(size_t by) const;
  };
  /// Vertices of two opposite sides, to be joined.
  struct Cut {
    size_t from, to;
    double skew;  // m: how far the end lies off the point opposite to the start; negative: there is no cut
  };

  void add(const SourceFace& face);
  uint32_t corner(uint32_t of_faces);
  uint32_t add_vertex(Point3 p) { return builder_.add_vertex(*face_, p); }
  void add_patch(const Corners& c);
  void open_shooter(const Corners& outline);
  void close_shooter();

  double distance(uint32_t a, uint32_t b) const {
    return length(Vec3d(mesh_.positions[a]) - Vec3d(mesh_.positions[b]));
  }
  uint32_t vertex(Side s, size_t k) const { return pool_[size_t(s.at(k))]; }
  double length_of(Side s) const;
  double along(Side s, size_t k) const;
  double unevenness(Side s) const;
  Corners corners(const Region& r) const;
  bool fits(const Corners& corners, double size) const;

  Side edge(uint32_t a, uint32_t b);
  Side straight(uint32_t a, uint32_t b);
  void divide(uint32_t a, uint32_t b, std::vector<uint32_t>& run);

  void cut(const Region& r);
  void cut_triangle(const Region& r);
  void cut_quad(const Region& r);
  bool peel(const Region& r);
  Cut best_cut(const Region& r) const;
  void cut_across(const Region& r, size_t from, size_t to);
  void cut_diagonally(const Region& r);

  bool is_grid(const Region& r) const;
  bool match(Side a, Side opposite) const;
  void add_grid(const Region& r);
  void add_block(size_t column, size_t columns, size_t row, size_t rows);
  Corners block(size_t column, size_t columns, size_t row, size_t rows) const;

  PatchMesh& mesh_;
  PatchBuilder& builder_;
  PatchSizes sizes_;
  const Junctions& junctions_;
  const SourceFaces* faces_ = nullptr;
  const SourceFace* face_ = nullptr;
  bool in_shooter_ = false;
  std::vector<uint32_t> ids_;  // vertex of the mesh for each of the faces' corners
  std::vector<uint32_t> pool_, run_;
  std::vector<uint32_t> grid_;                                 // vertices, row by row
  size_t grid_columns_ = 0;                                    // vertices in a row
  std::unordered_map<uint64_t, std::vector<uint32_t>> edges_;  // vertices along the edges of faces
  std::vector<Point3> found_;
};

}  // namespace aktina
