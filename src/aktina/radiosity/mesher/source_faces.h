// A scene's surfaces in world space: the polygons that meshers cut into patches.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

/// A triangle, or two triangles of a mesh that together are a planar convex quadrilateral.
/// Counter-clockwise seen from the front.
struct SourceFace {
  std::array<uint32_t, 4> corners;    // into SourceFaces::positions; the last two of a triangle are equal
  std::array<uint32_t, 2> triangles;  // of the mesh; both the same for a triangle
  bool is_quad() const { return corners[2] != corners[3]; }
};

/// The faces of one instance.
class SourceFaces {
 public:
  /// Triangles without area or with positions that are not finite are left out and counted.
  SourceFaces(const Scene& scene, uint32_t instance);

  std::vector<Point3> positions;  // m, world, of the vertices in use
  std::vector<SourceFace> list;
  uint64_t degenerate = 0;

  /// Where a point on a face lies: the triangle it is in, and its barycentric coordinates there.
  SurfacePoint place(const SourceFace& face, Point3 point) const;
  /// Unit shading normal, world, at a place.
  Vec3 normal(const SurfacePoint& place) const;
  /// Attributes of the mesh at a place.
  Vec2 uv(const SurfacePoint& place, int set) const;
  Vec4 colour(const SurfacePoint& place) const;

 private:
  struct Corners {
    std::array<uint32_t, 3> ids;
    bool usable;
  };
  void add_faces(const std::vector<Corners>& corners);
  bool join(uint32_t first, const Corners& a, const Corners& b);

  const Mesh& mesh_;
  uint32_t instance_;
  Mat4 to_world_;
  Mat3 normal_matrix_;
  bool mirrored_;
  Mesh flat_;  // the mesh with normals of its own, where it has none
};

}  // namespace aktina
