// A scene as the rasterizer reads it: all triangles in world space, as structures of arrays.
#pragma once

#include <deque>
#include <span>

#include "aktina/raster/line_array.h"
#include "aktina/scene/scene.h"

namespace aktina {

/// An instance: a range of vertices and of triangles, of one material.
struct DrawPart {
  const Mesh* mesh;  // null: a bare list of triangles
  const Material* material;
  uint32_t first_vertex, vertex_count;  // the first is a multiple of kLanes
  uint32_t first_triangle, triangle_count;
  bool flat;  // a mesh without normals: three vertices of its own for each triangle

  /// The mesh's vertex behind a vertex of the draw list.
  uint32_t mesh_vertex(uint32_t vertex) const {
    const uint32_t local = vertex - first_vertex;
    return flat ? mesh->triangles[local / 3][local % 3] : local;
  }
};

/// Triangles are counted through instance by instance, as in ItemBuffer; counter-clockwise seen from the front, also
/// where a placement mirrors them.
class DrawList {
 public:
  static constexpr uint64_t kMostTriangles = uint64_t(1) << 27;

  /// Keeps references into the scene, which must outlive it. Vertices without a usable normal get a face's.
  /// @throws Error limit (too many triangles), bad_input (an index beyond the vertices)
  explicit DrawList(const Scene& scene);
  /// Triangles in world space without attributes: for item buffers.
  DrawList(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles);

  uint32_t vertex_count() const { return vertex_count_; }
  uint32_t triangle_count() const { return triangle_count_; }
  std::span<const DrawPart> parts() const { return parts_; }
  const float* position(int axis) const { return position_[axis].data(); }
  const float* normal(int axis) const { return normal_[axis].data(); }
  const uint32_t* index(int corner) const { return index_[corner].data(); }
  Point3 position_of(uint32_t v) const { return {position_[0][v], position_[1][v], position_[2][v]}; }
  Vec3 normal_of(uint32_t v) const { return {normal_[0][v], normal_[1][v], normal_[2][v]}; }

 private:
  void add(const Mesh& mesh, const Instance& instance, const Material& material);
  void add_corners(const Mesh& mesh, const DrawPart& part, bool mirrored);
  void add_normals(const Mesh& mesh, const DrawPart& part, const Mat4& to_world);
  void set_position(uint32_t vertex, Point3 p);
  void set_normal(uint32_t vertex, Vec3 n);

  uint32_t vertex_count_ = 0, triangle_count_ = 0;
  LineArray<float> position_[3], normal_[3];
  LineArray<uint32_t> index_[3];
  std::vector<DrawPart> parts_;
  std::deque<Mesh> tessellated_;  // of primitives; addresses stay
};

}  // namespace aktina
