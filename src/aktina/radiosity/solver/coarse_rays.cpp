#include "aktina/radiosity/solver/coarse_rays.h"

#include <algorithm>

#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr int kMostLayers = 64;  // clear surfaces along a ray
constexpr float kLeastShare = 1e-3f;
constexpr uint32_t kMostPlaces = 32;  // until one is open

}  // namespace

aktina::Ray CoarseRays::start(const Ray& ray) const {
  const uint32_t seed = hash_combine(seed_, ray.from);
  CoarsePatches::Place place = patches_.place(ray.from, sobol_owen(ray.number, seed));
  if (patches_.partly_open(place.side))
    for (uint32_t k = 1; k < kMostPlaces && !hits_.open(place.side, place.point); ++k)
      place.point = sides_.point(place.side, sobol_owen(ray.number, hash_combine(seed, k)));
  const Vec3 n = sides_.normal(place.side);
  const Vec3 direction = Frame(n).to_world(sample_cosine_hemisphere(sobol_owen(ray.number, hash32(seed))));
  return {place.point + hits_.offset() * n, direction, 0, kInfinity};
}

void CoarseRays::follow(std::span<const Ray> rays, std::vector<Arrival>& arrivals) const {
  RayPacket packet{};
  for (size_t first = 0; first < rays.size(); first += kPacket) {
    const size_t count = std::min(rays.size() - first, size_t(kPacket));
    for (size_t k = 0; k < count; ++k) packet.set(int(k), start(rays[first + k]));
    follow(packet, (1U << count) - 1, uint32_t(first), arrivals);
  }
}

void CoarseRays::follow(RayPacket& packet, uint32_t lanes, uint32_t first, std::vector<Arrival>& arrivals) const {
  HitPacket hits;
  float shares[kPacket];
  std::fill(std::begin(shares), std::end(shares), 1.0f);
  for (int layer = 0; lanes && layer < kMostLayers; ++layer) {
    hits_.intersect(packet, lanes, hits);
    for (int i = 0; i < kPacket; ++i) {
      if (!(lanes >> i & 1)) continue;
      const Hit hit = hits.at(i);
      const uint32_t shooter = hit ? hits_.shooter(hit, packet.at(i).direction) : ShooterHits::kNobody;
      if (shooter != ShooterHits::kNobody)
        arrivals.push_back({first + uint32_t(i), patches_.patch_of_shooter(shooter), shares[i]});
      if (hit) shares[i] *= hits_.passing(hit);
      if (!hit || shares[i] < kLeastShare) lanes &= ~(1U << i);
      packet.near[i] = hit.distance * (1 + 1e-5f) + hits_.offset();
    }
  }
}

}  // namespace aktina
