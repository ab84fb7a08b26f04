// A source face as a plane with an outline, in double precision.
#pragma once

#include "aktina/radiosity/mesher/face_cells.h"
#include "aktina/radiosity/mesher/patch_builder.h"

namespace aktina {

struct FlatFace {
  uint32_t instance, face;  // of SceneFaces: index into faces, and into their list
  FacePolygon corners;      // m, world
  Vec3d normal;             // unit
  double offset;            // m
  Bounds box;

  double distance(Point3d p) const { return dot(normal, p) - offset; }
  Point3d projected(Point3d p) const { return p - distance(p) * normal; }
  double diameter() const { return double(box.diagonal()); }
};

FlatFace flat_face(const SceneFaces& faces, uint32_t instance, uint32_t face);
std::vector<FlatFace> flat_faces(const SceneFaces& faces);
Bounds bounds(const SceneFaces& faces);

/// Faces to be replaced by convex parts of them.
struct FaceParts {
  uint32_t instance, face;  // as in FlatFace
  std::vector<FacePolygon> parts;
};
/// Puts parts in the place of faces. Corners that are nearer to each other than vertices may be become one; parts that
/// vanish are left out. @param cut  sorted by instance and face
void replace_faces(SceneFaces& faces, const std::vector<FaceParts>& cut);

}  // namespace aktina
