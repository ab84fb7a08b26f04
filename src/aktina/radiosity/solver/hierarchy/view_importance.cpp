#include "aktina/radiosity/solver/hierarchy/view_importance.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr uint32_t kPlaces = 16;  // on each piece: one packet
constexpr float kUsualAspect = 1.5f;

/// Camera space, and what of it the picture shows.
class Picture {
 public:
  explicit Picture(const Camera& camera) : camera_(camera), from_world_(glm::inverse(camera.to_world)) {
    const bool perspective = camera.kind == Camera::Kind::perspective;
    half_.y = perspective ? std::tan(camera.vertical_fov / 2) : camera.half_height;
    half_.x = half_.y * (camera.aspect > 0 ? camera.aspect : kUsualAspect);
  }

  /// Share of the picture over the area of a surface there, m^-2, if nothing is in between; 0: out of the picture.
  float density(Point3 place, Vec3 normal) const {
    const Vec3 p = transform_point(from_world_, place);
    const float depth = -p.z;
    if (!(depth > camera_.near && depth < camera_.far)) return 0;
    const bool perspective = camera_.kind == Camera::Kind::perspective;
    const float scale = perspective ? depth : 1;
    if (std::abs(p.x) > scale * half_.x || std::abs(p.y) > scale * half_.y) return 0;
    const float shown = 1 / (4 * half_.x * half_.y);
    if (!perspective) return shown * std::max(0.0f, -dot(normal, camera_.forward()));
    return shown * std::max(0.0f, dot(normal, camera_.position() - place)) / (depth * depth * depth);
  }
  /// From a place to the eye.
  Ray sight(Point3 start) const {
    if (camera_.kind == Camera::Kind::perspective) return {start, camera_.position() - start, 0, 1};
    const float depth = -transform_point(from_world_, start).z;
    return {start, -depth * camera_.forward(), 0, 1};
  }

 private:
  const Camera& camera_;
  Mat4 from_world_;
  Vec2 half_;
};

Point3 place_on(const std::array<Point3, 4>& c, Vec2 u) {
  if (c[2] != c[3])
    return c[0] + u.x * (1 - u.y) * (c[1] - c[0]) + u.x * u.y * (c[2] - c[0]) + u.y * (1 - u.x) * (c[3] - c[0]);
  if (u.x + u.y > 1) u = Vec2(1) - u;
  return c[0] + u.x * (c[1] - c[0]) + u.y * (c[2] - c[0]);
}

/// What a piece takes up of the picture.
double seen(const SurfaceLayout::Piece& piece, Vec3 normal, const Picture& picture, const Visibility& visibility,
            uint32_t seed) {
  float sum = 0;
  VisibilityQueue queue(visibility, Coherence::coherent, &sum);
  for (uint32_t k = 0; k < kPlaces; ++k) {
    const Point3 place = place_on(piece.corners, sobol_owen(k, seed));
    const float density = picture.density(place, normal);
    if (density > 0) queue.add(picture.sight(place + visibility.offset() * normal), 0, density);
  }
  queue.flush();
  return piece.area * double(sum) / kPlaces;
}

}  // namespace

std::vector<double> view_importance(const SurfaceLayout& layout, size_t receivers, const Visibility& visibility,
                                    const Camera& view, uint32_t seed) {
  const Picture picture(view);
  std::vector<double> shares(layout.pieces.size());
  parallel_for(layout.faces.size(), 16, [&](size_t begin, size_t end) {
    for (size_t face = begin; face < end; ++face)
      for (uint32_t k = layout.first_pieces[face]; k < layout.first_pieces[face + 1]; ++k)
        shares[k] =
            seen(layout.pieces[k], layout.faces[face].normal, picture, visibility, hash_combine(seed, uint32_t(k)));
  });
  std::vector<double> importances(receivers, 0), areas(receivers, 0);
  for (size_t k = 0; k < shares.size(); ++k)
    importances[layout.pieces[k].receiver] += shares[k], areas[layout.pieces[k].receiver] += layout.pieces[k].area;
  for (size_t r = 0; r < receivers; ++r) importances[r] = areas[r] > 0 ? importances[r] / areas[r] : 0;
  return importances;
}

}  // namespace aktina
