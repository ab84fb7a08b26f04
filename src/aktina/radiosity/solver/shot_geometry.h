// Who receives and who shoots, as shots see it: single sides, or coarse patches of many polygons.
#pragma once

#include <span>
#include <vector>

#include "aktina/radiosity/solver/coarse_patches.h"
#include "aktina/radiosity/solver/sides.h"

namespace aktina {

class ShotGeometry {
 public:
  struct Piece {
    std::array<Point3, 4> corners;  // the last two of a triangle are equal
    Vec3 normal;
    float area, upto;  // m^2: its own, and of the shooter's pieces up to and with it
  };
  /// A place on the shooter, evenly over its area, and the normal there.
  struct Target {
    Point3 point;
    Vec3 normal;
  };
  /// Sides receive, their shooters shoot.
  explicit ShotGeometry(const Sides& sides);
  /// Coarse patches shoot; they receive, or sides do.
  ShotGeometry(const Sides& sides, const CoarsePatches& patches, bool sides_receive);

  size_t receivers() const { return receiving_ ? receiving_->size() : sides_.size(); }
  Point3 centre(size_t r) const { return sides_.centre(receiving_ ? receiving_->middle(r) : r); }
  Vec3 normal(size_t r) const { return sides_.normal(receiving_ ? receiving_->middle(r) : r); }
  /// A place on the receiver, evenly over its area.
  CoarsePatches::Place place(size_t r, Vec2 u) const {
    return receiving_ ? receiving_->place(r, u) : CoarsePatches::Place{uint32_t(r), sides_.point(r, u)};
  }
  const Sides& sides() const { return sides_; }
  /// The coarse patches that receive; null: sides do.
  const CoarsePatches* receiving() const { return receiving_; }

  std::span<const Piece> pieces(size_t shooter) const {
    return {pieces_.data() + first_[shooter], first_[shooter + 1] - first_[shooter]};
  }
  Target target(size_t shooter, Vec2 u) const;
  bool emits(size_t shooter) const { return emits_[shooter]; }

 private:
  void add_piece(const Sides::Shooter& shooter);

  const Sides& sides_;
  const CoarsePatches* receiving_ = nullptr;
  std::vector<Piece> pieces_;
  std::vector<uint32_t> first_{0};
  std::vector<uint8_t> emits_;
};

}  // namespace aktina
