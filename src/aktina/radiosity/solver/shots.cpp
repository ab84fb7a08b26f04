#include "aktina/radiosity/solver/shots.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr size_t kChunk = 256;  // receivers
constexpr int kMostSamples = 4 * RayCastShots::kMostSamples;
constexpr double kFar = 0.02;      // solid angle below which one ray is enough
constexpr float kGrazing = 1e-5f;  // of the patch's size: heights that count as lying in its plane

/// A polygon cut by the plane z = 0, z measured along n: at most five corners are left of four.
struct Clipped {
  Vec3d p[8];
  int count = 0;
};

Clipped above_horizon(const Vec3d (&corners)[4], int n, Vec3d normal) {
  Clipped out;
  for (int k = 0; k < n; ++k) {
    const Vec3d a = corners[k], b = corners[(k + 1) % n];
    const double za = dot(a, normal), zb = dot(b, normal);
    if (za > 0) out.p[out.count++] = a;
    if ((za > 0) != (zb > 0)) out.p[out.count++] = a + (b - a) * (za / (za - zb));
  }
  return out;
}

/// Lambert's formula; the contour clockwise seen from the origin's side of its plane would be negative.
double contour_sum(const Clipped& c, Vec3d n) {
  double sum = 0;
  for (int k = 0; k < c.count; ++k) {
    const Vec3d a = c.p[k], b = c.p[k + 1 == c.count ? 0 : k + 1], g = cross(b, a);
    const double sine = length(g);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(n, g) / sine;
  }
  return sum / (2 * kPi);
}

Point3 point_on(const std::array<Point3, 4>& c, Vec2 u) {
  if (c[2] != c[3]) return (c[0] * (1 - u.x) + c[1] * u.x) * (1 - u.y) + (c[3] * (1 - u.x) + c[2] * u.x) * u.y;
  const float root = std::sqrt(u.x);
  return c[0] * (1 - root) + (c[1] * (1 - u.y) + c[2] * u.y) * root;
}

}  // namespace

double point_to_corners(Point3 x, Vec3 n, const std::array<Point3, 4>& corners, Vec3 corners_normal) {
  const int count = corners[2] != corners[3] ? 4 : 3;
  Vec3d r[4];
  double size = 0, distance = 1e300;
  for (int k = 0; k < count; ++k) {
    r[k] = Vec3d(corners[size_t(k)]) - Vec3d(x);
    size = std::max(size, squared_length(r[k] - r[0]));
    distance = std::min(distance, squared_length(r[k]));
  }
  const double height = -dot(r[0], Vec3d(corners_normal));
  if (!(height > double(kGrazing) * std::sqrt(size))) return 0;
  const Clipped above = above_horizon(r, count, Vec3d(n));
  if (above.count < 3) return 0;
  if (size > 1e-6 * distance) return std::clamp(contour_sum(above, Vec3d(n)), 0.0, 1.0);
  Vec3d twice(0), middle(0);  // far away the sum would cancel
  for (int k = 0; k < above.count; ++k) {
    if (k >= 2) twice += cross(above.p[k - 1] - above.p[0], above.p[k] - above.p[0]);
    middle += above.p[k] / double(above.count);
  }
  const double squared = squared_length(middle);
  return std::max(0.0, -0.5 * dot(twice, middle) * dot(Vec3d(n), middle) / (kPi * squared * squared));
}

void RayCastShots::column(size_t shooter, std::span<double> factors) const {
  const size_t chunks = (factors.size() + kChunk - 1) / kChunk;
  parallel_for(chunks, 1, [&](size_t begin, size_t end) {
    for (size_t chunk = begin; chunk < end; ++chunk)
      column(shooter, chunk * kChunk, std::min((chunk + 1) * kChunk, factors.size()), factors);
  });
}

void RayCastShots::column(size_t shooter, size_t begin, size_t end, std::span<double> factors) const {
  const Sides::Shooter& from = sides_.shooters()[shooter];
  float passed[kChunk] = {};
  VisibilityQueue queue(visibility_, Coherence::coherent, passed);
  for (size_t s = begin; s < end; ++s) {
    factors[s] = point_to_corners(sides_.centre(s), sides_.normal(s), from.corners, from.normal);
    if (factors[s] == 0) continue;
    const int samples = from.emits ? 4 * samples_ : factors[s] < kFar ? 1 : samples_;
    if (!look(from, s, samples, hash_combine(hash_combine(seed_, uint32_t(shooter)), uint32_t(s)), s - begin, queue))
      passed[s - begin] = 1;  // a sliver above the horizon that no sample has met
  }
  queue.flush();
  for (size_t s = begin; s < end; ++s) factors[s] *= double(std::min(passed[s - begin], 1.0f));
}

/// Sends shadow rays from receiver s to the patch, each weighted as its place contributes to the factor.
bool RayCastShots::look(const Sides::Shooter& from, size_t s, int samples, uint32_t seed, size_t owner,
                        VisibilityQueue& queue) const {
  const Point3 x = sides_.centre(s);
  const Vec3 n = sides_.normal(s);
  float weights[kMostSamples], sum = 0;
  Point3 places[kMostSamples];
  for (int k = 0; k < samples; ++k) {
    places[k] = point_on(from.corners, sobol_owen(uint32_t(k), seed));
    const Vec3 d = places[k] - x;
    const float squared = squared_length(d);
    weights[k] = std::max(0.0f, dot(n, d)) * std::max(0.0f, -dot(from.normal, d)) / (squared * squared);
    sum += weights[k];
  }
  if (!(sum > 0)) return false;
  for (int k = 0; k < samples; ++k)
    if (weights[k] > 0) queue.add(visibility_.between(x, n, places[k], from.normal), uint32_t(owner), weights[k] / sum);
  return true;
}

}  // namespace aktina
