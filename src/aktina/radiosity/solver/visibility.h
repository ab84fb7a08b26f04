// How much light gets from one place to another through the scene: by rays, many at a time.
#pragma once

#include <memory>
#include <vector>

#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"

namespace aktina {

/// How far rays start off surfaces, m: beyond what positions and hits are rounded by, below what a scene has gaps of.
float ray_offset(const Bounds& scene);

/// The share of light that passes between points: 0 behind something opaque, tau (by luminance) for each surface that
/// lets light straight through, 1 where nothing is in between.
class Visibility {
 public:
  /// @param scene  without analytic primitives; must outlive this
  explicit Visibility(const Scene& scene);

  /// For the lanes whose bit is set; the others are left alone.
  void passing(const RayPacket& rays, uint32_t lanes, Coherence coherence, float* shares) const;

  /// How far rays start off surfaces, m.
  float offset() const { return offset_; }
  Ray between(Point3 from, Vec3 from_normal, Point3 to, Vec3 to_normal) const {
    const Point3 start = from + offset_ * from_normal;
    return {start, to + offset_ * to_normal - start, 0, 1};
  }
  Ray towards(Point3 from, Vec3 from_normal, Vec3 direction, float distance = kInfinity) const {
    return {from + offset_ * from_normal, direction, 0, distance};
  }

 private:
  float through(const Hit& hit) const;

  const Scene& scene_;
  std::unique_ptr<Accelerator> accelerator_;
  std::vector<bool> clear_;  // by instance: lets some light through somewhere
  bool any_clear_ = false;
  float offset_ = 0;
};

/// Rays gathered into packets; each belongs to somebody, and their shares are added up for him.
class VisibilityQueue {
 public:
  VisibilityQueue(const Visibility& visibility, Coherence coherence, float* sums)
      : visibility_(visibility), coherence_(coherence), sums_(sums) {}
  /// Adds weight times what passes to sums[owner].
  void add(const Ray& ray, uint32_t owner, float weight = 1) {
    rays_.set(count_, ray);
    owners_[count_] = owner, weights_[count_] = weight;
    if (++count_ == kPacket) flush();
  }
  void flush();

 private:
  const Visibility& visibility_;
  Coherence coherence_;
  float* sums_;
  RayPacket rays_{};
  uint32_t owners_[kPacket];
  float weights_[kPacket];
  int count_ = 0;
};

}  // namespace aktina
