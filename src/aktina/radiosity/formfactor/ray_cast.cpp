// Shadow rays from points of the receiver to places all over the source; each counts as the disc that it stands for,
// A/n cos cos / (pi r^2 + A/n), which stays bounded where they touch. The sum of the discs itself is too low near by
// and is only used for the share that gets through; the unobstructed factor of a point is Lambert's exact one. Cost:
// points x samples rays a pair that something may stand between, none otherwise. Weakness: the receiver's points are
// few; the edges of shadows are noisy.
//
// J. Wallace, K. Elmquist, E. Haines, "A Ray Tracing Algorithm for Progressive Radiosity", SIGGRAPH '89.
#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/formfactor/face_rays.h"
#include "aktina/radiosity/formfactor/occluded.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"

namespace aktina {
namespace {

struct Receiver {
  Point3d x;
  Vec3d n;
};

class RayCast final : public FaceRaysMethod {
 public:
  RayCast(uint32_t points, uint32_t samples, uint32_t seed) : points_(points), samples_(samples), seed_(seed) {}

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    const uint32_t seed = hash_combine(seed_, uint32_t(i));
    std::vector<Receiver> receivers;
    for (uint32_t p = 0; p < points_; ++p)
      receivers.push_back({point_on(faces_[i], Vec2d(sobol_owen(p, seed))), faces_[i].plane.normal});
    FormFactorRow row;
    for (size_t j = 0; j < faces_.size(); ++j) {
      RunningStatistics mean;
      const bool hidden = i != j && something_between(i, j);
      for (uint32_t p = 0; p < points_ && i != j; ++p)
        mean.add(
            factor(receivers[p], faces_[j], hidden ? samples_ : 0, hash_combine(hash_combine(seed, p), uint32_t(j))));
      row.factors.push_back(mean.mean());
      row.errors.push_back(i == j || points_ == 1 ? 0 : mean.standard_error());
    }
    return row;
  }

  FormFactorRow row(Point3d x, Vec3d n) const override {
    const Receiver receiver{x, checked_normal(x, n)};
    FormFactorRow row;
    const uint32_t samples = points_ * samples_;  // as many rays as a patch sends
    for (size_t j = 0; j < faces_.size(); ++j) {
      const double all = point_to_polygon(x, receiver.n, faces_[j]);
      const double f =
          factor(receiver, faces_[j], faces_.blockers(j).empty() ? 0 : samples, hash_combine(seed_, uint32_t(j)));
      row.factors.push_back(f), row.errors.push_back(std::sqrt(std::max(0.0, f * (all - f)) / samples));
    }
    return row;
  }

 private:
  bool something_between(size_t i, size_t j) const {
    const std::vector<const Face*> blockers = faces_.blockers(i, j);
    return std::any_of(blockers.begin(), blockers.end(),
                       [&](const Face* face) { return may_hide(*face, faces_[i], faces_[j]); });
  }

  /// @param samples  0: nothing can be in between
  double factor(const Receiver& receiver, const Face& source, uint32_t samples, uint32_t seed) const {
    const double all = point_to_polygon(receiver.x, receiver.n, source);
    return all == 0 || samples == 0 ? all : all * share(receiver, source, samples, seed);
  }

  /// The share of the discs that the receiver sees.
  double share(const Receiver& receiver, const Face& source, uint32_t samples, uint32_t seed) const {
    double passed = 0, sum = 0;
    for (uint32_t first = 0; first < samples; first += kPacket) {
      RayPacket rays;
      double weights[kPacket] = {};
      uint32_t lanes = 0;
      for (int lane = 0; lane < kPacket && first + uint32_t(lane) < samples; ++lane) {
        const Point3d y = point_on(source, Vec2d(sobol_owen(first + uint32_t(lane), seed)));
        weights[lane] = disc(receiver, source, y, samples);
        if (weights[lane] == 0) continue;
        const Point3 from = rays_.lifted(receiver.x, receiver.n), to = rays_.lifted(y, source.plane.normal);
        rays.set(lane, {from, to - from, 0, 1});
        lanes |= 1U << lane;
      }
      const uint32_t blocked = lanes ? rays_.accelerator().occluded(rays, lanes, Coherence::coherent) : 0;
      for (int lane = 0; lane < kPacket; ++lane) {
        sum += weights[lane];
        if (!(blocked >> lane & 1)) passed += weights[lane];
      }
    }
    return sum > 0 ? passed / sum : 1;  // a sliver above the horizon that no sample has met
  }

  static double disc(const Receiver& receiver, const Face& source, Point3d y, uint32_t samples) {
    const Vec3d d = y - receiver.x;
    const double squared = squared_length(d), area = source.area / samples;
    const double cosines = std::max(0.0, dot(receiver.n, d)) * std::max(0.0, -dot(source.plane.normal, d));
    return squared > 0 ? cosines / squared * area / (kPi * squared + area) : 0;
  }

  uint32_t points_, samples_, seed_;
};

constexpr Param kParams[] = {{"points", "1", "receiving points on each surface", 256, 1, 65536, true},
                             {"samples", "1", "shadow rays from each point to each surface", 16, 1, 65536, true},
                             {"seed", "1", "of the random numbers", 0, 0, 4294967295.0, true}};

}  // namespace

extern constinit const FormFactorMethodRow ray_cast_formfactor = {
    {"ray_cast", "Ray-cast form factors", "wallace1989",
     "Shadow rays to places on the source, from points of the receiver: any scene, any number of occluders; noise at "
     "the "
     "edges of shadows.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return std::make_unique<RayCast>(uint32_t(params["points"]), uint32_t(params["samples"]),
                                       uint32_t(params["seed"]));
    }};

}  // namespace aktina
