#include "aktina/radiosity/solver/shot_geometry.h"

#include <algorithm>
#include <cmath>

namespace aktina {

ShotGeometry::Target ShotGeometry::target(size_t shooter, Vec2 u) const {
  const std::span<const Piece> all = pieces(shooter);
  const float at = u.x * all.back().upto;
  const auto piece = std::min(
      std::upper_bound(all.begin(), all.end(), at, [](float v, const Piece& p) { return v < p.upto; }), all.end() - 1);
  u.x = std::clamp((at - (piece->upto - piece->area)) / piece->area, 0.0f, 1.0f);
  const auto& c = piece->corners;
  if (c[2] != c[3])
    return {(c[0] * (1 - u.x) + c[1] * u.x) * (1 - u.y) + (c[3] * (1 - u.x) + c[2] * u.x) * u.y, piece->normal};
  const float root = std::sqrt(u.x);
  return {c[0] * (1 - root) + (c[1] * (1 - u.y) + c[2] * u.y) * root, piece->normal};
}

void ShotGeometry::add_piece(const Sides::Shooter& s) {
  const auto& c = s.corners;
  const Vec3 twice = c[2] != c[3] ? cross(c[2] - c[0], c[3] - c[1]) : cross(c[1] - c[0], c[2] - c[0]);
  const float area = 0.5f * length(twice), before = pieces_.size() > first_.back() ? pieces_.back().upto : 0;
  pieces_.push_back({c, s.normal, area, before + area});
}

ShotGeometry::ShotGeometry(const Sides& sides) : sides_(sides) {
  for (const Sides::Shooter& s : sides.shooters()) {
    add_piece(s);
    first_.push_back(uint32_t(pieces_.size())), emits_.push_back(s.emits);
  }
}

ShotGeometry::ShotGeometry(const Sides& sides, const CoarsePatches& patches, bool sides_receive)
    : sides_(sides), receiving_(sides_receive ? nullptr : &patches) {
  for (size_t i = 0; i < patches.size(); ++i) {
    bool emits = false;
    for (const uint32_t s : patches.shooters(i))
      add_piece(sides.shooters()[s]), emits = emits || sides.shooters()[s].emits;
    first_.push_back(uint32_t(pieces_.size())), emits_.push_back(emits);
  }
}

}  // namespace aktina
