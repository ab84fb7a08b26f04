#include "aktina/radiosity/solver/direct_light.h"

#include <algorithm>
#include <optional>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/trace/environment_sampler.h"

namespace aktina {
namespace {

constexpr uint32_t kLampSamples = 4;  // places on a patch, each with a ray to each lamp
constexpr uint32_t kSkySamples = 64;  // places on a patch, each with a ray to the sky; of a picture half each way
constexpr size_t kGrain = 64;         // sides
constexpr size_t kBlock = 1 << 14;    // sides between two looks whether a checkpoint is due

/// A ray and what arrives along it if nothing is in between.
struct Question {
  Ray ray;
  Rgb light;
};

class SideLight {
 public:
  /// @param sky  of the lights; null where there is none
  SideLight(const LightGroup& lights, const EnvironmentSampler* sky, const Sides& sides, const Visibility& visibility,
            uint32_t seed)
      : lights_(lights), sky_(sky), sides_(sides), visibility_(visibility), seed_(seed) {}

  Rgb of(size_t side) {
    questions_.clear();
    const uint32_t seed = hash_combine(seed_, uint32_t(side));
    for (uint32_t k = 0; k < kLampSamples; ++k) {
      const Point3 x = sides_.point(side, sobol_owen(k, seed));
      for (const PlacedLight& lamp : lights_.lamps) ask(x, sides_.normal(side), lamp.light);
    }
    if (sky_) ask_sky(side, seed);
    return answer();
  }

 private:
  void ask(Point3 x, Vec3 n, const Light& lamp) {
    const LightSample s = sample(lamp, x);
    const float cosine = dot(s.wi, n);
    if (cosine > 0 && !is_black(s.e_perp.v))
      questions_.push_back({visibility_.towards(x, n, s.wi, s.distance), s.e_perp.v * (cosine / float(kLampSamples))});
  }
  /// By the cosine, and where the sky is a picture by its brightness as well: suns are small. Both kinds of samples are
  /// weighted by the balance heuristic (E. Veach, L. Guibas, SIGGRAPH '95).
  void ask_sky(size_t side, uint32_t seed) {
    const bool picture = !lights_.sky->radiance.empty();
    const uint32_t bright = picture ? kSkySamples / 2 : 0, even = kSkySamples - bright;
    const Vec3 n = sides_.normal(side);
    const Frame frame(n);
    const auto ask = [&](uint32_t k, uint32_t stream, const auto& direction_at) {
      const Vec3 direction = direction_at(sobol_owen(k, hash32(stream)));
      const float cosine = dot(direction, n);
      const Rgb l = radiance(*lights_.sky, direction).v;
      if (!(cosine > 0) || is_black(l)) return;
      const float density = float(even) * cosine * float(kInvPi) + (picture ? float(bright) * sky_->pdf(direction) : 0);
      questions_.push_back(
          {visibility_.towards(sides_.point(side, sobol_owen(k, stream)), n, direction), l * (cosine / density)});
    };
    for (uint32_t k = 0; k < even; ++k)
      ask(k, seed, [&](Vec2 u) { return frame.to_world(sample_cosine_hemisphere(u)); });
    for (uint32_t k = 0; k < bright; ++k)
      ask(k, hash_combine(seed, 1), [&](Vec2 u) { return sky_->sample(u).direction; });
  }

  Rgb answer() const {
    Rgb sum;
    for (size_t first = 0; first < questions_.size(); first += kPacket) {
      const size_t count = std::min(questions_.size() - first, size_t(kPacket));
      RayPacket rays{};
      float shares[kPacket];
      for (size_t i = 0; i < count; ++i) rays.set(int(i), questions_[first + i].ray);
      visibility_.passing(rays, (1U << count) - 1, Coherence::incoherent, shares);
      for (size_t i = 0; i < count; ++i) sum += questions_[first + i].light * shares[i];
    }
    return sum;
  }

  const LightGroup& lights_;
  const EnvironmentSampler* sky_;
  const Sides& sides_;
  const Visibility& visibility_;
  uint32_t seed_;
  std::vector<Question> questions_;
};

}  // namespace

void direct_light(const LightGroup& lights, const Sides& sides, std::span<const uint32_t> of,
                  const Visibility& visibility, uint32_t seed, Progress* progress, KeptList<Rgb>& illuminance) {
  if (!lights.has_lamps()) return;
  std::optional<EnvironmentSampler> sky;
  if (lights.sky) sky.emplace(*lights.sky);
  if (progress) progress->begin("direct light", "patches", of.size());
  illuminance.loop.run(of.size(), kBlock, progress, [&](size_t first, size_t last) {
    parallel_for(last - first, kGrain, [&](size_t begin, size_t end) {
      if (progress && progress->cancelled()) return;
      SideLight light(lights, sky ? &*sky : nullptr, sides, visibility, seed);
      for (size_t i = first + begin; i < first + end; ++i) illuminance.values[i] = light.of(of[i]);
      if (progress) progress->advance(end - begin);
    });
  });
}

}  // namespace aktina
