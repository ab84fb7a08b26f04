// What rays meet among the outlines of what shoots: coarser than the patches, so that the structure stays small.
#pragma once

#include <memory>
#include <vector>

#include "aktina/radiosity/solver/sides.h"
#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"

namespace aktina {

class ShooterHits {
 public:
  static constexpr uint32_t kNobody = 0xffffffff;

  /// `sides` must outlive this.
  explicit ShooterHits(const Sides& sides);

  void intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits) const {
    accelerator_->intersect(rays, lanes, hits, Coherence::incoherent);
  }
  /// Whose side the ray arrives at; kNobody: the back of a one-sided surface, which takes up all light.
  uint32_t shooter(const Hit& hit, Vec3 direction) const {
    const uint32_t front = owners_[hit.triangle];
    return dot(hit.normal, direction) < 0 ? front : backs_[front];
  }
  /// The share of light that goes straight on, by luminance.
  float passing(const Hit& hit) const { return passing_.empty() ? 0 : passing_[owners_[hit.triangle]]; }

  /// How far rays start off surfaces, m.
  float offset() const { return offset_; }

  /// Something else than backs of one-sided surfaces is seen from a place on a side.
  bool open(size_t side, Point3 place) const;
  /// By side: the share of its area that is open; what a box stands on is not. Judged by the middle, by many places
  /// where the side is large beside what may stand on it.
  std::vector<float> open_shares() const;

 private:
  void add(uint32_t shooter);
  bool sees_only_backs(size_t side, Point3 place, uint32_t first, uint32_t count) const;
  float open_share(size_t side, uint32_t places) const;

  const Sides& sides_;
  Scene outlines_;  // one mesh
  std::vector<uint32_t> owners_, backs_;
  std::vector<float> passing_;  // of shooters; empty: nothing passes
  std::unique_ptr<Accelerator> accelerator_;
  float offset_ = 0;
};

}  // namespace aktina
