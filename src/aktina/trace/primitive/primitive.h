// Rays against the analytic shapes of scene/primitive.h, in the shape's own space.
#pragma once

#include <optional>
#include <span>

#include "aktina/base/method.h"
#include "aktina/scene/primitive.h"
#include "aktina/trace/intersect.h"

namespace aktina {

/// Nearest point of the surface on the line; both sides count.
std::optional<SurfaceHit> intersect(const Sphere& sphere, const Line& line);
std::optional<SurfaceHit> intersect(const Disc& disc, const Line& line);
std::optional<SurfaceHit> intersect(const Cylinder& cylinder, const Line& line);
std::optional<SurfaceHit> intersect(const Cone& cone, const Line& line);
inline std::optional<SurfaceHit> intersect(const Primitive& primitive, const Line& line) {
  return std::visit([&](const auto& shape) { return intersect(shape, line); }, primitive);
}

/// A sphere anywhere.
std::optional<SurfaceHit> intersect_sphere(const Line& line, Point3d centre, double radius);

std::span<const Method<Primitive>* const> primitives();

}  // namespace aktina
