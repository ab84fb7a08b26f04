#include "aktina/radiosity/formfactor/face_rays.h"

#include <algorithm>
#include <cmath>

namespace aktina {

void FaceRays::build(const Faces& faces) {
  Point3d low(INFINITY), high(-INFINITY);
  for (const auto* list : {&faces.surfaces(), &faces.occluders()})
    for (const Face& face : *list)
      low = glm::min(low, face.centre - face.radius), high = glm::max(high, face.centre + face.radius);
  if (low.x <= high.x) centre_ = 0.5 * (low + high), unit_ = 0.5 * length(high - low);
  scene_ = std::make_unique<Scene>();
  owners_.clear();
  Mesh mesh;
  uint32_t owner = 0;
  for (const auto* list : {&faces.surfaces(), &faces.occluders()})
    for (const Face& face : *list) {
      for (const Contour& piece : face.convex) {
        if (!face.hides) break;
        const auto first = uint32_t(mesh.positions.size());
        for (const Point3d& v : piece) mesh.positions.push_back(Vec3((v - centre_) / unit_));
        for (uint32_t k = 1; k + 1 < piece.size(); ++k) {
          mesh.triangles.push_back({first, first + k, first + k + 1});
          owners_.push_back(owner);
        }
      }
      ++owner;
    }
  scene_->meshes.push_back(std::move(mesh));
  scene_->instances.push_back({.mesh = 0});
  accelerator_ = build_accelerator(*scene_);
}

Point3d point_on(const Face& face, Vec2d u) {
  double rest = u.x * face.area;
  Point3d a(0), b(0), c(0);
  double part = 0;
  for (const Contour& piece : face.convex)
    for (size_t k = 1; k + 1 < piece.size(); ++k) {
      const double area = 0.5 * length(cross(piece[k] - piece[0], piece[k + 1] - piece[0]));
      if (area <= 0) continue;
      a = piece[0], b = piece[k], c = piece[k + 1];
      part = std::min(rest / area, 1.0);
      if (rest < area) return a + std::sqrt(part) * (b + u.y * (c - b) - a);
      rest -= area;
    }
  return a + std::sqrt(part) * (b + u.y * (c - b) - a);  // rounding has gone beyond the last one
}

}  // namespace aktina
