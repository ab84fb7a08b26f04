// Light that arrives at a point from all that shines in a scene: lamps, emissive surfaces, the sky.
#pragma once

#include <vector>

#include "aktina/scene/scene.h"
#include "aktina/trace/emitter.h"
#include "aktina/trace/environment_sampler.h"
#include "aktina/trace/light_tree.h"
#include "aktina/trace/ray.h"

namespace aktina {

/// A direction from which light comes, unless something is in between.
struct ArrivingLight {
  Vec3 wi;        // unit
  Rgb e_perp;     // lx on a plane facing wi, over the chance of this lamp; of areas: L / pdf. Black: nothing
  float pdf = 0;  // sr^-1, of the direction in all; 0 for lamps without an extent
  Point3 target;  // the shadow ray ends here, just before the light; where `distant`, a direction instead
  bool distant = false;
};

/// Lamps and emissive triangles are chosen by a light tree; suns and the sky, where both kinds are there, half the
/// time. Surfaces that are `unlit` do not shine upon others.
class LightSampler {
 public:
  /// `scene` must outlive this.
  explicit LightSampler(const Scene& scene);

  bool empty() const { return tree_.empty() && distant_.empty(); }
  /// There is nothing to choose.
  bool only_one() const { return tree_.only_one() ? distant_.empty() : tree_.empty() && distant_.size() == 1; }
  /// @param choice  chooses the lamp; u  a place on it
  ArrivingLight sample(Point3 x, float choice, Vec2 u) const;
  /// The density with which sample() at x gives the direction in which a ray has met an emissive surface, sr^-1.
  /// @param cosine  |of the angle between ray and surface|
  float pdf(Point3 x, const Hit& hit, float distance, float cosine) const;
  /// The same for a ray that has met the sky.
  float sky_pdf(Vec3 direction) const;

 private:
  struct Distant {
    const Light* lamp;    // directional; null: the sky
    float chance, until;  // its own, and cumulated
  };
  void add_instance(uint32_t index, std::vector<LampBounds>& bounds);
  void add_distant(const std::vector<const Light*>& suns);
  ArrivingLight sample_distant(Point3 x, float choice, Vec2 u) const;
  ArrivingLight sample_near(Point3 x, float choice, Vec2 u) const;

  const Scene* scene_;
  EnvironmentSampler sky_;
  LightTree tree_;
  std::vector<Emitter> emitters_;
  std::vector<uint32_t> first_;       // of each instance, into emitter_of_; kNothing: it does not shine
  std::vector<uint32_t> emitter_of_;  // of each triangle or shape that shines
  std::vector<Distant> distant_;
  float distant_chance_ = 0;
};

}  // namespace aktina
