#include "aktina/radiosity/viewfactor/sight_rays.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr uint32_t kFewest = 64, kMost = 4096;

/// Uniform by area on a convex polygon.
Point3d point_in(std::span<const Point3d> polygon, Vec2 u) {
  double areas[8] = {}, all = 0;
  for (size_t k = 1; k + 1 < polygon.size(); ++k)
    all += areas[k] = length(cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]));
  double rest = double(u.x) * all;
  size_t k = 1;
  while (k + 2 < polygon.size() && rest >= areas[k]) rest -= areas[k++];
  const double along = areas[k] > 0 ? std::sqrt(std::min(rest / areas[k], 1.0)) : 0;
  return polygon[0] + along * (polygon[k] - polygon[0] + double(u.y) * (polygon[k + 1] - polygon[k]));
}

}  // namespace

Estimate SightRays::visible_share(std::span<const Point3d> receiver, Vec3d n, std::span<const Point3d> source, Vec3d m,
                                  double wanted, uint32_t seed) const {
  std::call_once(built_, [&] { rays_.build(faces_); });
  double passed[2] = {}, sum[2] = {};  // of every other packet
  Estimate share{0, 1};
  uint32_t sent = 0;
  for (uint32_t limit = kFewest; limit <= kMost && share.error > wanted; limit *= 4) {
    for (; sent < limit; sent += kPacket) {
      RayPacket packet;
      double weights[kPacket];
      for (int lane = 0; lane < kPacket; ++lane) {
        const Point3d x = point_in(receiver, sobol_owen(sent + uint32_t(lane), hash_combine(seed, 1)));
        const Point3d y = point_in(source, sobol_owen(sent + uint32_t(lane), hash_combine(seed, 2)));
        const Vec3d d = y - x;
        const double squared = squared_length(d);
        weights[lane] = std::max(0.0, dot(n, d)) * std::max(0.0, -dot(m, d)) / std::max(squared * squared, 1e-300);
        const Point3 from = rays_.lifted(x, n), to = rays_.lifted(y, m);
        packet.set(lane, {from, to - from, 0, 1});
      }
      const uint32_t blocked = rays_.accelerator().occluded(packet, kAllLanes, Coherence::coherent);
      const int half = int(sent / kPacket) & 1;
      for (int lane = 0; lane < kPacket; ++lane) {
        sum[half] += weights[lane];
        if (!(blocked >> lane & 1)) passed[half] += weights[lane];
      }
    }
    if (!(sum[0] > 0 && sum[1] > 0)) return {1, 1};
    const double value = (passed[0] + passed[1]) / (sum[0] + sum[1]);
    const double spread = std::max(value * (1 - value), 1.0 / sent);
    // The samples are stratified: the two halves agree better than independent ones would. Neither bounds the error.
    share = {value, std::max(std::abs(passed[0] / sum[0] - passed[1] / sum[1]), 0.3 * std::sqrt(spread / sent))};
  }
  return share;
}

}  // namespace aktina
