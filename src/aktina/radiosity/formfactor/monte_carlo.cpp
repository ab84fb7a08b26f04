// Rays from everywhere on a patch, in directions whose density is the cosine: cosine and 1/pi cancel, so that a form
// factor is the share of rays that arrive. Cost: one ray a sample for a whole row, whatever the number of patches.
// Weakness: the error sqrt(F (1 - F) / N) at worst (stratified samples do better): small factors are found by luck.
//
// T. Malley, "A Shading Method for Computer Generated Images", master's thesis, University of Utah 1988 (its sampling);
// P. Shirley, "Radiosity via Ray Tracing", Graphics Gems II, 1991.
#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/radiosity/formfactor/face_rays.h"

namespace aktina {
namespace {

class MonteCarlo final : public FaceRaysMethod {
 public:
  MonteCarlo(uint32_t samples, uint32_t seed) : packets_((samples + kPacket - 1) / kPacket), seed_(seed) {}

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    const uint32_t seed = hash_combine(seed_, uint32_t(i));
    return shoot(faces_[i].plane.normal, seed, [&](uint32_t sample) {
      return point_on(faces_[i], Vec2d(sobol_owen(sample, hash_combine(seed, 1))));
    });
  }

  FormFactorRow row(Point3d x, Vec3d n) const override {
    return shoot(checked_normal(x, n), seed_, [&](uint32_t) { return x; });
  }

 private:
  template <class Origin>
  FormFactorRow shoot(Vec3d normal, uint32_t seed, Origin&& origin) const {
    const Frame frame{Vec3(normal)};
    std::vector<uint64_t> arrived(faces_.size(), 0);
    for (uint32_t packet = 0; packet < packets_; ++packet) {
      RayPacket rays;
      HitPacket hits;
      for (int lane = 0; lane < kPacket; ++lane) {
        const uint32_t sample = packet * kPacket + uint32_t(lane);
        rays.set(lane, {rays_.lifted(origin(sample), normal),
                        frame.to_world(sample_cosine_hemisphere(sobol_owen(sample, hash_combine(seed, 2))))});
      }
      rays_.accelerator().intersect(rays, kAllLanes, hits, Coherence::incoherent);
      for (int lane = 0; lane < kPacket; ++lane) {
        if (hits.instance[lane] == kNothing) continue;
        const size_t face = rays_.face_of(hits.triangle[lane]);
        if (face < faces_.size() && dot(Vec3d(rays.at(lane).direction), faces_[face].plane.normal) < 0) ++arrived[face];
      }
    }
    const double n = double(packets_) * kPacket;
    FormFactorRow row;
    for (const uint64_t count : arrived) {
      const double f = double(count) / n, spread = std::max(f, 1 / n);  // no hit is no proof
      row.factors.push_back(f), row.errors.push_back(std::sqrt(spread * std::max(1 - f, 1 / n) / n));
    }
    return row;
  }

  uint32_t packets_, seed_;
};

constexpr Param kParams[] = {
    {"samples", "1", "rays from each surface, rounded up to sixteens", 65536, 16, 16777216, true},
    {"seed", "1", "of the random numbers", 0, 0, 4294967295.0, true}};

}  // namespace

extern constinit const FormFactorMethodRow monte_carlo_formfactor = {
    {"monte_carlo", "Monte Carlo with cosine-weighted rays", "malley1988",
     "The share of stratified rays that arrive: a whole row for one set of rays, in any scene; noisy for small "
     "factors.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return std::make_unique<MonteCarlo>(uint32_t(params["samples"]), uint32_t(params["seed"]));
    }};

}  // namespace aktina
