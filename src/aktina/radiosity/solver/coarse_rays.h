// Rays between coarse patches, through the scene.
#pragma once

#include "aktina/radiosity/solver/coarse_patches.h"
#include "aktina/radiosity/solver/problem.h"
#include "aktina/radiosity/solver/shooter_hits.h"

namespace aktina {

/// From places spread over each patch, by the cosine about the normal there; both scrambled Sobol points of the patch's
/// own. What lets light through receives it and hands its share on.
class CoarseRays final : public LightRays {
 public:
  CoarseRays(const CoarsePatches& patches, const Sides& sides, const ShooterHits& hits, uint32_t seed)
      : patches_(patches), sides_(sides), hits_(hits), seed_(seed) {}
  void follow(std::span<const Ray> rays, std::vector<Arrival>& arrivals) const override;

 private:
  void follow(RayPacket& packet, uint32_t lanes, uint32_t first, std::vector<Arrival>& arrivals) const;
  aktina::Ray start(const Ray& ray) const;

  const CoarsePatches& patches_;
  const Sides& sides_;
  const ShooterHits& hits_;
  uint32_t seed_;
};

}  // namespace aktina
