// An analytic shape somewhere in the world: what the accelerators share about primitives.
#pragma once

#include <optional>

#include "aktina/trace/primitive/primitive.h"
#include "aktina/trace/ray.h"

namespace aktina {

class PlacedPrimitive {
 public:
  /// `shape` must outlive this.
  PlacedPrimitive(const Primitive& shape, const Mat4& to_world);

  Bounds bounds() const;  // world, tight
  /// Nearest hit in the ray's interval, without its instance.
  std::optional<Hit> intersect(const Ray& ray) const;
  /// The point of the surface next to a world point near it: where a hit stands, without the error of a long ray.
  Point3 snap(Point3 world) const;
  /// Surface parameters of a world point on the shape, both in [0, 1]: u once around +y as for environment maps
  /// (atan2(x, -z) / 2 pi + 1/2), v from the top (sphere: acos(y / r) / pi; cylinder, cone: 1 - y / h) or from the
  /// centre (disc).
  Vec2 uv(Point3 world) const;

 private:
  const Primitive* shape_;
  Mat4 to_world_;
  Mat4d to_local_;
};

}  // namespace aktina
