#include "aktina/radiosity/viewfactor/sight_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr uint32_t kMost = 4096;  // rays a pair
constexpr double kMuch = 0.03;    // of the smaller part's light, that reaches the larger

/// Stratified numbers, the same for all pairs; each pair shifts them by numbers of its own.
class Shifted {
 public:
  Shifted(uint32_t stream, uint32_t seed)
      : table_(tables()[stream]),
        shift_(unit_float(hash_combine(seed, 2 * stream)), unit_float(hash_combine(seed, 2 * stream + 1))) {}
  Vec2 operator[](uint32_t k) const {
    const Vec2 u = table_[k] + shift_;
    return {u.x >= 1 ? u.x - 1 : u.x, u.y >= 1 ? u.y - 1 : u.y};
  }

 private:
  using Tables = std::array<std::vector<Vec2>, 2>;
  static const Tables& tables() {
    static const Tables made = [] {
      Tables tables;
      for (uint32_t stream = 0; stream < 2; ++stream)
        for (uint32_t k = 0; k < kMost; ++k) tables[stream].push_back(sobol_owen(k, 0x51ed27 + stream));
      return tables;
    }();
    return made;
  }
  const std::vector<Vec2>& table_;
  Vec2 shift_;
};

/// Uniform by area on a convex polygon.
class Points {
 public:
  explicit Points(std::span<const Point3d> polygon) : polygon_(polygon) {
    for (size_t k = 1; k + 1 < polygon.size(); ++k)
      all_ += areas_[k] = length(cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]));
  }
  double area() const { return 0.5 * all_; }
  Point3d at(Vec2 u) const {
    double rest = double(u.x) * all_;
    size_t k = 1;
    while (k + 2 < polygon_.size() && rest >= areas_[k]) rest -= areas_[k++];
    const double along = areas_[k] > 0 ? std::sqrt(std::min(rest / areas_[k], 1.0)) : 0;
    return polygon_[0] + along * (polygon_[k] - polygon_[0] + double(u.y) * (polygon_[k + 1] - polygon_[k]));
  }

 private:
  std::span<const Point3d> polygon_;
  std::array<double, 8> areas_{};
  double all_ = 0;
};

/// A ray and what it counts.
struct Sample {
  Point3d from, to;
  double weight;
};

/// Places evenly over both parts, weighted by the kernel.
Sample between(const SightRays::Part& a, const Points& on_a, const SightRays::Part& b, const Points& on_b, Vec2 u,
               Vec2 v) {
  const Point3d x = on_a.at(u), y = on_b.at(v);
  const Vec3d d = y - x;
  const double squared = squared_length(d);
  return {x, y,
          std::max(0.0, dot(a.normal, d)) * std::max(0.0, -dot(b.normal, d)) / std::max(squared * squared, 1e-300)};
}

/// By the cosine about the normal of part a; counts 1 where it meets part b.
Sample by_cosine(const SightRays::Part& a, const Points& on_a, const SightRays::Part& b, Vec2 u, Vec2 v) {
  const Point3d x = on_a.at(u);
  const Vec3d d(Frame(Vec3(a.normal)).to_world(sample_cosine_hemisphere(v)));
  const double falls = -dot(b.normal, d), height = dot(b.normal, x - b.corners[0]);
  if (!(falls > 1e-9 && height > 0)) return {x, x, 0};
  const Point3d y = x + height / falls * d;
  for (size_t k = 0; k < b.corners.size(); ++k) {
    const Point3d &p = b.corners[k], &q = b.corners[k + 1 == b.corners.size() ? 0 : k + 1];
    if (dot(b.normal, cross(q - p, y - p)) < 0) return {x, y, 0};
  }
  return {x, y, 1};
}

}  // namespace

Estimate SightRays::visible_share(const Part& receiver, const Part& source, double exchange, double wanted,
                                  uint32_t seed) const {
  if (!built_) return {0, 1};
  const Points receivers(receiver.corners), sources(source.corners);
  const Shifted here(0, seed), there(1, seed);
  const bool swapped = sources.area() < receivers.area();
  const bool near = exchange > kMuch * std::min(sources.area(), receivers.area());
  const Part &small = swapped ? source : receiver, &large = swapped ? receiver : source;
  const Points &on_small = swapped ? sources : receivers, &on_large = swapped ? receivers : sources;
  double passed[2] = {}, sum[2] = {}, squares = 0;  // of weights; of every other packet
  Estimate share{0, 1};
  uint32_t sent = 0;
  // Where any share is good enough, one packet keeps the sum over many pairs right.
  for (uint32_t limit = wanted >= 0.5 ? kPacket : 4 * kPacket; limit <= kMost && share.error > wanted; limit *= 4) {
    for (; sent < limit; sent += kPacket) {
      RayPacket packet;
      double weights[kPacket];
      uint32_t lanes = 0;
      for (int lane = 0; lane < kPacket; ++lane) {
        const Vec2 u = here[sent + uint32_t(lane)], v = there[sent + uint32_t(lane)];
        const Sample sample =
            near ? by_cosine(small, on_small, large, u, v) : between(small, on_small, large, on_large, u, v);
        weights[lane] = sample.weight;
        if (sample.weight > 0) lanes |= 1U << lane;
        const Point3 from = rays_.lifted(sample.from, small.normal), to = rays_.lifted(sample.to, large.normal);
        packet.set(lane, {from, to - from, 0, 1});
      }
      const uint32_t blocked = lanes ? rays_.accelerator().occluded(packet, lanes, Coherence::coherent) : 0;
      const int half = int(sent / kPacket) & 1;
      for (int lane = 0; lane < kPacket; ++lane) {
        sum[half] += weights[lane], squares += weights[lane] * weights[lane];
        if (!(blocked >> lane & 1)) passed[half] += weights[lane];
      }
    }
    if (!(sum[0] + sum[1] > 0)) continue;
    const double value = (passed[0] + passed[1]) / (sum[0] + sum[1]);
    const double count = (sum[0] + sum[1]) * (sum[0] + sum[1]) / squares;  // of rays that weigh alike
    const double spread = std::max(value * (1 - value), 1.0 / count);
    // The samples are stratified: the two halves agree better than independent ones would. Neither bounds the error.
    const double apart = sum[0] > 0 && sum[1] > 0 ? std::abs(passed[0] / sum[0] - passed[1] / sum[1]) : 0;
    share = {value, std::max(apart, 0.3 * std::sqrt(spread / count))};
  }
  if (!(sum[0] + sum[1] > 0)) return {1, 1};
  return share;
}

}  // namespace aktina
