// The accelerators: the only list, and what they share.
#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"

namespace aktina {

extern const Method<std::unique_ptr<Accelerator>> embree_accelerator, brute_force_accelerator;

std::span<const Method<std::unique_ptr<Accelerator>>* const> accelerators() {
  static constexpr const Method<std::unique_ptr<Accelerator>>* kTable[] = {&embree_accelerator,
                                                                           &brute_force_accelerator};
  return kTable;
}

Hit Accelerator::intersect(const Ray& ray) const {
  RayPacket rays;
  HitPacket hits;
  rays.set(0, ray);
  intersect(rays, 1, hits, Coherence::incoherent);
  return hits.at(0);
}

bool Accelerator::occluded(const Ray& ray) const {
  RayPacket rays;
  rays.set(0, ray);
  return occluded(rays, 1, Coherence::incoherent) != 0;
}

std::unique_ptr<Accelerator> build_accelerator(const Scene& scene) {
  // Measured: up to here testing everything is quicker than a hierarchy; shapes are tested one ray at a time.
  constexpr uint64_t kHandful = 64, kTrianglesPerShape = 16;
  uint64_t work = triangle_count(scene);
  for (const Instance& instance : scene.instances)
    if (instance.mesh < 0 && instance.primitive >= 0) work += kTrianglesPerShape;
  auto accelerator = make_method(accelerators(), "accelerator", work <= kHandful ? "brute_force" : "embree");
  accelerator->build(scene);
  return accelerator;
}

}  // namespace aktina
