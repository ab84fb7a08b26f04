#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/statistics.h"
#include "aktina/trace/illuminance.h"
#include "aktina/trace/offset.h"
#include "aktina/trace/radiance.h"

namespace aktina {
namespace {

constexpr int kRound = 64, kLeastRounds = 4;  // samples a point in a round

bool meets_back(const Accelerator& accelerator, Point3 from, Vec3 direction) {
  const Hit hit = accelerator.intersect(Ray{from, direction});
  return hit && dot(hit.normal, direction) > 0;
}

/// Places of points outside of bodies.
std::vector<uint32_t> outside(const RayScene& scene, std::span<const Point3> points) {
  std::vector<uint8_t> inside(points.size());
  parallel_for(points.size(), 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      inside[i] =
          meets_back(*scene.accelerator, points[i], {0, 1, 0}) && meets_back(*scene.accelerator, points[i], {0, -1, 0});
  });
  std::vector<uint32_t> out;
  for (uint32_t i = 0; i < points.size(); ++i)
    if (!inside[i]) out.push_back(i);
  return out;
}

class Meter {
 public:
  Meter(const RayScene& scene, const MeasureOptions& options, std::span<const Point3> points,
        std::span<const Vec3> normals)
      : scene_(scene), options_(options), asked_(points.size()), measured_(outside(scene, points)) {
    for (const uint32_t at : measured_) points_.push_back(points[at]), normals_.push_back(normals[at]);
    integrator_ = make_integrator(scene, {.integrator = options.integrator});
    statistics_.resize(measured_.size());
  }

  /// One more value of each point. @throws Error cancelled
  void round(uint32_t number, Progress* progress) {
    std::vector<double> values(measured_.size());
    const uint32_t seed = hash_combine(options_.seed, hash32(number));
    parallel_for(measured_.size(), 16, [&](size_t begin, size_t end) {
      if (progress) progress->throw_if_cancelled();
      std::vector<Rgb> sums(end - begin);
      sum_illuminance(scene_, *integrator_, points_, normals_, begin, end, 0, kRound, seed, sums);
      for (size_t i = begin; i < end; ++i) values[i] = double(luminance(sums[i - begin])) / kRound;
    });
    for (size_t i = 0; i < values.size(); ++i) statistics_[i].add(values[i]);
  }

  /// Root mean square of the standard errors over the average.
  double error() const {
    double squares = 0, sum = 0;
    for (const RunningStatistics& s : statistics_) squares += s.standard_error() * s.standard_error(), sum += s.mean();
    return sum > 0 ? std::sqrt(squares * double(statistics_.size())) / sum : 0;
  }

  Measurement result() const {
    Measurement m;
    m.lux.assign(asked_, std::numeric_limits<double>::quiet_NaN());
    m.standard_errors = m.lux;
    for (size_t i = 0; i < measured_.size(); ++i)
      m.lux[measured_[i]] = statistics_[i].mean(), m.standard_errors[measured_[i]] = statistics_[i].standard_error();
    m.inside = asked_ - measured_.size();
    m.error = error();
    m.reached = m.error <= options_.target_error;
    return m;
  }

 private:
  const RayScene& scene_;
  const MeasureOptions& options_;
  size_t asked_;
  std::vector<uint32_t> measured_;  // their places among those that were asked for
  std::vector<Point3> points_;      // of those
  std::vector<Vec3> normals_;
  std::unique_ptr<Integrator> integrator_;
  std::vector<RunningStatistics> statistics_;
};

}  // namespace

Measurement measure_illuminance(const Scene& scene, std::span<const Point3> points, std::span<const Vec3> normals,
                                const MeasureOptions& options, Progress* progress) {
  if (points.size() != normals.size())
    throw Error(Code::usage, "illuminance", fmt::format("{} points but {} normals", points.size(), normals.size()));
  std::vector<Point3> off(points.size());
  for (size_t i = 0; i < points.size(); ++i) off[i] = offset_point(points[i], normals[i]);
  const RayScene prepared(scene, options.accelerator);
  Meter meter(prepared, options, off, normals);
  const int most = std::max(options.most_samples / kRound, kLeastRounds);
  if (progress) progress->begin("measuring", "rounds", uint64_t(most));
  int rounds = 0;
  try {
    do {
      meter.round(uint32_t(rounds), progress);
      ++rounds;
      if (progress) progress->advance();
    } while (rounds < most && (rounds < kLeastRounds || meter.error() > options.target_error));
  } catch (const Error& e) {
    if (e.code() != Code::cancelled || rounds < 2) throw;
  }
  Measurement result = meter.result();
  result.samples = rounds * kRound;
  return result;
}

}  // namespace aktina
