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

  /// Where sides receive: only these do from now on, counted in their order.
  void receive_only(std::vector<uint32_t> sides) { only_ = std::move(sides); }

  size_t receivers() const { return receiving_ ? receiving_->size() : only_.empty() ? sides_.size() : only_.size(); }
  Point3 centre(size_t r) const { return sides_.centre(middle(r)); }
  Vec3 normal(size_t r) const { return sides_.normal(middle(r)); }
  /// A place on the receiver, evenly over its area.
  CoarsePatches::Place place(size_t r, Vec2 u) const {
    if (receiving_) return receiving_->place(r, u);
    return {uint32_t(middle(r)), sides_.point(middle(r), u)};
  }
  /// What choices at random for a receiver depend on: whoever else receives.
  uint32_t identity(size_t r) const { return uint32_t(only_.empty() ? r : only_[r]); }
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
  /// The side in the middle of a receiver.
  size_t middle(size_t r) const { return receiving_ ? receiving_->middle(r) : identity(r); }

  const Sides& sides_;
  const CoarsePatches* receiving_ = nullptr;
  std::vector<uint32_t> only_;
  std::vector<Piece> pieces_;
  std::vector<uint32_t> first_{0};
  std::vector<uint8_t> emits_;
};

}  // namespace aktina
