// A handful of triangles against packets of rays, without a hierarchy: SIMD over the rays, one triangle at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "aktina/trace/ray.h"

namespace aktina {

/// A ray passes a directed edge on its left where direction . moment - edge . (2 origin x direction) > 0 (the inner
/// product of their Pluecker coordinates). Triangles that share an edge get exactly opposite values for it, so no ray
/// slips between them.
struct SoupTriangle {
  Vec3 edge[3];    // opposite to vertex k: from vertex k + 1 to vertex k + 2
  Vec3 moment[3];  // edge x (sum of its two ends)
  Vec3 normal;     // cross product of two edges; its length is twice the area
  float offset;    // normal . vertex 0
  float side;      // -1 where the instance mirrors its mesh: the front is on the other side of `normal`
  uint32_t triangle, instance;
};

class TriangleSoup {
 public:
  /// Triangles without area or with vertices that are not finite are left out: no ray meets them.
  void add(Point3 a, Point3 b, Point3 c, float side, uint32_t triangle, uint32_t instance);
  /// To be called once after the last add(): moves the origin to the middle, where floats are finest.
  void finish();

  /// Nearest hits of the lanes whose bit is set; at equal distances the triangle that was added first.
  void intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits) const;
  /// Bits of the lanes that meet a triangle.
  uint32_t occluded(const RayPacket& rays, uint32_t lanes) const;

 private:
  struct Corners {
    Point3 p[3];
    float side;
    uint32_t triangle, instance;
  };
  std::vector<Corners> corners_;
  std::vector<SoupTriangle> triangles_;
  Point3 centre_{0};
};

}  // namespace aktina
