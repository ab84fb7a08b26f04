// Shadow boundaries of one light on faces: where its shadow, or its umbra and penumbra, ends.
#pragma once

#include "aktina/radiosity/mesher/contacts.h"

namespace aktina {

/// A point, or a convex polygon that shines to its front.
struct ShadowLight {
  FacePolygon corners;
  Vec3d normal;   // of a polygon
  uint32_t face;  // of the list given: it casts no shadow in its own light; kNoFace for a point
  double power;   // to compare lights by
  static constexpr uint32_t kNoFace = 0xffffffff;
};

/// A convex volume: behind all of its planes.
struct ShadowVolume {
  struct Plane {
    Vec3d normal;
    double offset;
  };
  std::vector<Plane> planes;
};

/// The volumes that a convex polygon keeps some (`penumbra`) or all of the light from; those of a point are the same.
/// Planes through an edge of one and a corner of the other that have both on the same side, or one on each.
ShadowVolume shadow_volume(const FacePolygon& occluder, const FacePolygon& light, bool penumbra, double tolerance);

/// Boundaries of the union of all faces' shadows on each face, sorted by face. The penumbra's are exact; the umbra's
/// are those of single faces: what several of them keep dark together is within the penumbra.
std::vector<Contact> shadow_lines(const std::vector<FlatFace>& faces, const ShadowLight& light, double shortest,
                                  double tolerance);

}  // namespace aktina
