#include "aktina/radiosity/solver/shots.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr double kFar = 0.02;     // solid angle below which one ray is enough
constexpr float kSmall = 100;     // squared distance in squared sizes from where a middle stands for a polygon
constexpr float kClear = 0.999f;  // share of rays that pass where nothing is in the way
constexpr int kMoreInHalfShade = 4;
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

/// Much farther away than it is large: its middle stands for it.
bool far_away(Point3 x, const ShotGeometry::Piece& piece, Point3 middle) {
  return squared_length(middle - x) > kSmall * std::max(squared_length(piece.corners[0] - middle), piece.area);
}

double from_middle(Point3 x, Vec3 n, const ShotGeometry::Piece& piece, Point3 middle) {
  const Vec3 d = middle - x;
  const float squared = squared_length(d);
  return double(std::max(0.0f, dot(n, d)) * std::max(0.0f, -dot(piece.normal, d)) * piece.area /
                (float(kPi) * squared * squared));
}

/// Sums of what rays of the receivers of a chunk find.
struct Looks {
  float passed[kShotChunk] = {}, weights[kShotChunk] = {};
};

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

double unoccluded_factor(const ShotGeometry& geometry, size_t shooter, size_t receiver) {
  const Point3 x = geometry.centre(receiver);
  const Vec3 n = geometry.normal(receiver);
  const auto pieces = geometry.pieces(shooter);
  double sum = 0;
  for (const ShotGeometry::Piece& piece : pieces) {
    const auto& c = piece.corners;
    const Point3 middle = c[2] != c[3] ? 0.5f * (c[0] + c[2]) : (c[0] + c[1] + c[2]) * (1.0f / 3);
    sum += pieces.size() > 1 && far_away(x, piece, middle) ? from_middle(x, n, piece, middle)
                                                           : point_to_corners(x, n, c, piece.normal);
  }
  return std::min(sum, 1.0);
}

void occlude(const ShotGeometry& geometry, const Visibility& visibility, size_t shooter, size_t begin,
             std::span<const int> samples, uint32_t seed, std::span<double> factors) {
  Looks looks;
  VisibilityQueue queue(visibility, Coherence::coherent, looks.passed);
  const auto look = [&](size_t i, int from, int to) {
    const uint32_t own = hash_combine(hash_combine(seed, uint32_t(shooter)), geometry.identity(begin + i));
    for (int k = from; k < to; ++k) {
      const CoarsePatches::Place x = geometry.place(begin + i, sobol_owen(uint32_t(k), hash32(own)));
      const ShotGeometry::Target y = geometry.target(shooter, sobol_owen(uint32_t(k), own));
      const Vec3 d = y.point - x.point, n = geometry.sides().normal(x.side);
      const float squared = squared_length(d);
      const float weight = std::max(0.0f, dot(n, d)) * std::max(0.0f, -dot(y.normal, d)) / (squared * squared);
      if (!(weight > 0)) continue;
      looks.weights[i] += weight;
      queue.add(visibility.between(x.point, n, y.point, y.normal), uint32_t(i), weight);
    }
  };
  for (size_t i = 0; i < factors.size(); ++i)
    if (factors[i] > 0) look(i, 0, samples[i]);
  queue.flush();
  for (size_t i = 0; i < factors.size(); ++i)  // in the half shade
    if (looks.passed[i] > 0 && looks.passed[i] < kClear * looks.weights[i])
      look(i, samples[i], kMoreInHalfShade * samples[i]);
  queue.flush();
  for (size_t i = 0; i < factors.size(); ++i)  // a sliver above the horizon may be met by no sample
    if (looks.weights[i] > 0) factors[i] *= double(std::min(looks.passed[i] / looks.weights[i], 1.0f));
}

void RayCastShots::column(size_t shooter, std::span<double> factors) const {
  const size_t chunks = (factors.size() + kShotChunk - 1) / kShotChunk;
  parallel_for(chunks, 1, [&](size_t begin, size_t end) {
    int samples[kShotChunk];
    for (size_t chunk = begin; chunk < end; ++chunk) {
      const size_t first = chunk * kShotChunk, count = std::min(kShotChunk, factors.size() - first);
      for (size_t i = 0; i < count; ++i) {
        factors[first + i] = unoccluded_factor(geometry_, shooter, first + i);
        samples[i] = geometry_.emits(shooter) ? 4 * samples_ : factors[first + i] < kFar ? 1 : samples_;
      }
      occlude(geometry_, visibility_, shooter, first, {samples, count}, seed_, factors.subspan(first, count));
    }
  });
}

}  // namespace aktina
