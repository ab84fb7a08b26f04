#include "aktina/radiosity/solver/emitter_light.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/radiosity/solver/shots.h"

namespace aktina {
namespace {

constexpr size_t kBlock = 32 * kShotChunk;  // sides between two looks whether a checkpoint is due

}  // namespace

void add_emitter_light(const ShotGeometry& geometry, const Visibility& visibility, std::span<const uint32_t> shooters,
                       std::span<const Rgb> exitances, int samples, uint32_t seed, Progress* progress,
                       KeptList<Rgb>& light) {
  std::vector<Rgb>& irradiances = light.values;
  if (progress) progress->begin("light of emitters", "patches", irradiances.size());
  const auto chunks = [&](size_t from, size_t to, size_t begin, size_t end) {
    std::vector<double> factors(shooters.size() * kShotChunk), totals(kShotChunk);
    int rays[kShotChunk];
    for (size_t chunk = begin; chunk < end && !(progress && progress->cancelled()); ++chunk) {
      const size_t first = from + chunk * kShotChunk, count = std::min(kShotChunk, to - first);
      std::fill(totals.begin(), totals.end(), 0.0);
      for (size_t j = 0; j < shooters.size(); ++j)
        for (size_t i = 0; i < count; ++i) {
          double& factor = factors[j * kShotChunk + i];
          factor = unoccluded_factor(geometry, shooters[j], first + i);
          totals[i] += factor * double(luminance(exitances[j]));
        }
      for (size_t j = 0; j < shooters.size(); ++j) {
        const std::span<double> own(&factors[j * kShotChunk], count);
        for (size_t i = 0; i < count; ++i) {
          const double share = totals[i] > 0 ? own[i] * double(luminance(exitances[j])) / totals[i] : 0;
          rays[i] = std::max(1, int(std::ceil(samples * share)));
        }
        occlude(geometry, visibility, shooters[j], first, {rays, count}, seed, own);
        for (size_t i = 0; i < count; ++i) irradiances[first + i] += exitances[j] * float(own[i]);
      }
      if (progress) progress->advance(count);
    }
  };
  light.loop.run(irradiances.size(), kBlock, progress, [&](size_t from, size_t to) {
    parallel_for((to - from + kShotChunk - 1) / kShotChunk, 1,
                 [&](size_t begin, size_t end) { chunks(from, to, begin, end); });
  });
}

}  // namespace aktina
