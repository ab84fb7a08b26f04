#include "aktina/render/study/timing.h"

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr double kSlow = 1;  // s

void keep_least(double& least, double value) { least = least < value ? least : value; }  // NaN gives way

struct Contender {
  std::optional<Variant::Frames> frames;  // none: it cannot draw
  FrameTime time;
  bool done = false;

  void draw(Progress& progress, bool counts) {
    if (!frames || done) return;
    Stopwatch watch;
    frames->draw(progress);
    const double seconds = watch.lap();
    if (seconds > kSlow) done = true;
    if (!counts && !done) return;
    keep_least(time.seconds, seconds);
    keep_least(time.setup_seconds, frames->cost().setup_seconds);
    keep_least(time.pixel_seconds, frames->cost().pixel_seconds);
  }
};

}  // namespace

std::vector<FrameTime> race(std::span<const Variant* const> variants, const Camera& camera, int width, int height,
                            int rounds, int threads, Progress& progress) {
  set_thread_count(threads);
  std::vector<Contender> all(variants.size());
  for (size_t i = 0; i < all.size(); ++i) {
    all[i].time.threads = threads;
    if (variants[i]) all[i].frames.emplace(*variants[i], camera, width, height);
  }
  for (int round = -1; round < rounds; ++round)
    for (Contender& contender : all) {
      contender.draw(progress, round >= 0);
      progress.advance();
      progress.throw_if_cancelled();
    }
  std::vector<FrameTime> times;
  for (const Contender& contender : all) times.push_back(contender.time);
  return times;
}

}  // namespace aktina
