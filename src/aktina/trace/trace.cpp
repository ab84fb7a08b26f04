#include "aktina/trace/trace.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/image/file_format.h"
#include "aktina/trace/camera_rays.h"
#include "aktina/trace/first_hit.h"
#include "aktina/trace/illuminance.h"
#include "aktina/trace/offset.h"
#include "aktina/trace/radiance.h"

namespace aktina {
namespace {

constexpr int kMostTogether = 8;  // samples of a pixel in one pass

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Sums over the samples of a pixel.
struct Pixel {
  Rgb direct, indirect, illuminance;
  Pixel& operator+=(const Pixel& o) {
    direct += o.direct, indirect += o.indirect, illuminance += o.illuminance;
    return *this;
  }
};

/// Samples [first, first + count) of every pixel. Passes are cut the same way for any number of threads, and each
/// pixel's samples are summed in order.
struct Pass {
  int first, count;
  int tile() const { return count <= 2 ? 32 : 16; }  // side, px: about kBatch samples
};

TraceOptions seen_from(const Camera& camera, TraceOptions options) {
  options.depth_cue.eye = camera.position(), options.depth_cue.forward = camera.forward();
  return options;
}

class Tracer {
 public:
  Tracer(const Scene& scene, const Camera& camera, int width, int height, const TraceOptions& options)
      : options_(options),
        width_(width),
        height_(height),
        camera_(camera, width, height),
        scene_(scene, options.accelerator),
        integrator_(make_integrator(scene_, seen_from(camera, options))),
        sums_(size_t(width) * size_t(height)) {}

  /// @return  false: cancelled, nothing was added
  bool run(const Pass& pass, Progress* progress);
  LayeredImage picture(bool with_first_hits) const;
  const TraceStatistics& statistics() const { return statistics_; }
  int samples() const { return statistics_.samples; }

 private:
  void trace_tile(const Pass& pass, int left, int top, std::vector<Pixel>& out);
  std::vector<RadianceQuery> queries(const Pass& pass, int left, int top, std::vector<size_t>& pixels) const;
  void add_illuminance(std::span<const RadianceQuery> queries, std::span<const size_t> pixels, std::vector<Pixel>& out,
                       RayCounts& counts) const;

  TraceOptions options_;
  int width_, height_;
  CameraRays camera_;
  RayScene scene_;
  std::unique_ptr<Integrator> integrator_;
  std::vector<Pixel> sums_;
  std::mutex mutex_;
  TraceStatistics statistics_;
};

/// Blocks of 4 x 4 pixels, so that the rays of a packet go together. One sample goes through the pixel's centre.
std::vector<RadianceQuery> Tracer::queries(const Pass& pass, int left, int top, std::vector<size_t>& pixels) const {
  std::vector<RadianceQuery> out;
  const int tile = pass.tile();
  for (int block = 0; block < tile * tile / 16; ++block)
    for (int s = 0; s < pass.count; ++s)
      for (int i = 0; i < 16; ++i) {
        const int x = left + block % (tile / 4) * 4 + i % 4, y = top + block / (tile / 4) * 4 + i / 4;
        if (x >= width_ || y >= height_) continue;
        const size_t pixel = size_t(y) * size_t(width_) + size_t(x);
        const SampleSequence sequence{hash_combine(options_.seed, hash32(uint32_t(pixel))), uint32_t(pass.first + s)};
        const Vec2 place = options_.samples == 1 ? Vec2(0.5f) : sequence.pair(0);
        out.push_back({camera_.at(float(x) + place.x, float(y) + place.y), sequence});
        pixels.push_back(pixel);
      }
  return out;
}

void Tracer::add_illuminance(std::span<const RadianceQuery> rays, std::span<const size_t> pixels,
                             std::vector<Pixel>& out, RayCounts& counts) const {
  std::vector<IlluminanceQuery> queries;
  std::vector<size_t> targets;
  for (size_t i = 0; i < rays.size(); ++i) {
    ShadingPoint point;
    if (!first_solid_hit(scene_, rays[i].ray, point)) continue;
    queries.push_back({offset_point(point.position, point.geometric), point.normal, rays[i].sequence});
    targets.push_back(pixels[i]);
  }
  std::vector<Rgb> estimates(queries.size());
  estimate_illuminance(scene_, *integrator_, queries, estimates, counts);
  for (size_t i = 0; i < targets.size(); ++i)
    if (is_finite(estimates[i])) out[targets[i]].illuminance += estimates[i];
}

void Tracer::trace_tile(const Pass& pass, int left, int top, std::vector<Pixel>& out) {
  std::vector<size_t> pixels;
  const std::vector<RadianceQuery> rays = queries(pass, left, top, pixels);
  std::vector<RadianceEstimate> estimates(rays.size());
  RayCounts counts;
  integrator_->radiance(scene_, rays, true, estimates, counts);
  uint64_t not_finite = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    const RadianceEstimate& e = estimates[i];
    if (is_finite(e.total()))
      out[pixels[i]] += {e.emitted + e.direct, e.indirect, Rgb(0)};
    else
      ++not_finite;
  }
  if (options_.illuminance) add_illuminance(rays, pixels, out, counts);
  const std::lock_guard lock(mutex_);
  statistics_.rays += counts.rays, statistics_.shadow_rays += counts.shadow_rays;
  statistics_.not_finite += not_finite;
}

bool Tracer::run(const Pass& pass, Progress* progress) {
  std::vector<Pixel> added(sums_.size());
  const int side = pass.tile();
  const size_t columns = size_t((width_ + side - 1) / side), rows = size_t((height_ + side - 1) / side);
  parallel_for(columns * rows, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (progress && progress->cancelled()) return;
      const int left = int(i % columns) * side, top = int(i / columns) * side;
      trace_tile(pass, left, top, added);
      const int pixels = std::min(side, width_ - left) * std::min(side, height_ - top);
      if (progress) progress->advance(uint64_t(pixels) * uint64_t(pass.count));
    }
  });
  if (progress && progress->cancelled()) return false;
  for (size_t i = 0; i < sums_.size(); ++i) sums_[i] += added[i];
  statistics_.samples = pass.first + pass.count;
  return true;
}

LayeredImage Tracer::picture(bool with_first_hits) const {
  LayeredImage out;
  const float share = 1 / float(samples());
  const auto layer = [&](const char* name, auto value) {
    Image& image = out.add(name, width_, height_, 3);
    for (size_t i = 0; i < sums_.size(); ++i) {
      const Rgb c = value(sums_[i]) * share;
      for (int k = 0; k < 3; ++k) image.pixels[3 * i + size_t(k)] = c[k];
    }
  };
  layer("", [](const Pixel& p) { return p.direct + p.indirect; });
  if (with_first_hits) add_first_hit_layers(scene_, camera_, options_, out);
  if (options_.direct) layer("direct", [](const Pixel& p) { return p.direct; });
  if (options_.indirect) layer("indirect", [](const Pixel& p) { return p.indirect; });
  if (options_.illuminance) layer("illuminance", [](const Pixel& p) { return p.illuminance; });
  return out;
}

void check_size(int width, int height) {
  if (width < 1 || height < 1 || uint64_t(width) * uint64_t(height) > kMostPixels)
    throw Error(Code::limit, "trace.size", fmt::format("got {} x {} px", width, height),
                fmt::format("at least 1 x 1, {} pixels in all", kMostPixels));
}

}  // namespace

LayeredImage trace(const Scene& scene, const Camera& camera, int width, int height, const TraceOptions& options,
                   Progress* progress, TraceStatistics* statistics) {
  check_size(width, height);
  check_samples(options.samples);
  const double begun = seconds();
  Tracer tracer(scene, camera, width, height, options);
  const double built = seconds();
  if (progress) progress->begin("tracing", "samples", uint64_t(width) * uint64_t(height) * uint64_t(options.samples));
  bool going = true;
  while (going && tracer.samples() < options.samples) {
    const int done = tracer.samples();
    going = tracer.run({done, std::min({std::max(done, 1), kMostTogether, options.samples - done})}, progress);
    if (going && options.each_pass) options.each_pass(tracer.picture(false), tracer.samples());
  }
  if (tracer.samples() == 0) throw Error(Code::cancelled, "trace", "stopped before the first pass was done");
  LayeredImage picture = tracer.picture(true);
  if (statistics) {
    *statistics = tracer.statistics();
    statistics->build_seconds = built - begun, statistics->trace_seconds = seconds() - built;
  }
  return picture;
}

}  // namespace aktina
