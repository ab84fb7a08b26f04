#include "aktina/radiosity/solver/hierarchy/transport.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/radiosity/solver/shots.h"

namespace aktina {
namespace {

constexpr size_t kMostPoints = 9;
constexpr float kNear = 2.0f;     // distance of middles in sums of radii
constexpr float kSent = 0.25f;    // what the sender's range counts: light that is even on it does not mind
constexpr int kDeepest = 3;       // cuts of one or the other
constexpr float kBehind = 1e-5f;  // of the size: what counts as lying in a plane

struct Places {
  alignas(32) float x[kMostPoints + 7], y[kMostPoints + 7], z[kMostPoints + 7];
  Point3 at(size_t k) const { return {x[k], y[k], z[k]}; }
};

void find_places(const TreePatch& patch, std::span<const BasisPoint> points, Places& places) {
  for (size_t k = 0; k < points.size(); ++k) {
    const Point3 p = patch.point(float(points[k].x), float(points[k].y));
    places.x[k] = p.x, places.y[k] = p.y, places.z[k] = p.z;
  }
}

/// Form factor from one point to the sender, as if the kernel were the same all over it as at another point.
float kernel_at(Point3 from, Vec3 n, Point3 to, Vec3 m, float area) {
  const Vec3 d = to - from;
  const float cosines = std::max(0.0f, dot(n, d)) * std::max(0.0f, -dot(m, d)), squared = squared_length(d);
  return cosines > 0 ? cosines * area / (float(kPi) * squared * squared) : 0;
}

void sample_kernel(const Places& xs, size_t rows, Vec3 n, const Places& ys, size_t columns, Vec3 m, float area,
                   float* kernel) {
  const float scale = area / float(kPi);
  for (size_t a = 0; a < rows; ++a)
    for (size_t b = 0; b < columns; ++b) {
      const float dx = ys.x[b] - xs.x[a], dy = ys.y[b] - xs.y[a], dz = ys.z[b] - xs.z[a];
      const float leaves = std::max(0.0f, n.x * dx + n.y * dy + n.z * dz);
      const float arrives = std::max(0.0f, -(m.x * dx + m.y * dy + m.z * dz));
      const float squared = dx * dx + dy * dy + dz * dz + 1e-30f;
      kernel[a * columns + b] = scale * leaves * arrives / (squared * squared);
    }
}

/// Smallest and largest of what is shown to it.
struct Range {
  float low = 1e30f, high = 0;
  void add(float value) { low = std::min(low, value), high = std::max(high, value); }
  float size() const { return high - low; }
};

/// How much the form factor changes over the receiver, and over the sender: at the samples and in the middle, for by
/// symmetry the samples may all see the same.
float range_of(const TreePatch& receiver, std::span<const BasisPoint> rows, const Places& xs, const TreePatch& sender,
               std::span<const BasisPoint> columns, const Places& ys, const float* kernel, float* factors) {
  Range received, sent;
  const auto between = [&](Point3 x, Point3 y) {
    return kernel_at(x, receiver.normal, y, sender.normal, float(sender.area));
  };
  float from_middle = 0, to_middle = 0;
  for (size_t a = 0; a < rows.size(); ++a) {
    factors[a] = 0;
    for (size_t b = 0; b < columns.size(); ++b) factors[a] += float(columns[b].weight) * kernel[a * columns.size() + b];
    received.add(factors[a]);
    to_middle += float(rows[a].weight) * between(xs.at(a), sender.middle());
  }
  for (size_t b = 0; b < columns.size(); ++b) {
    float sum = 0;
    for (size_t a = 0; a < rows.size(); ++a) sum += float(rows[a].weight) * kernel[a * columns.size() + b];
    sent.add(sum);
    from_middle += float(columns[b].weight) * between(receiver.middle(), ys.at(b));
  }
  received.add(from_middle), sent.add(to_middle);
  return std::max(received.size(), kSent * sent.size());
}

bool behind(const TreePatch& what, const TreePatch& plane) {
  const float margin = kBehind * (plane.radius() + what.radius());
  for (const Point3 p : what.corners())
    if (dot(p - plane.corner, plane.normal) > margin) return false;
  return true;
}

float exact_factor(Point3 x, Vec3 n, const TreePatch& sender) {
  return float(point_to_corners(x, n, sender.corners(), sender.normal));
}

/// Mean form factor by Gauss points.
float mean_factor(const TreePatch& receiver, const TreePatch& sender) {
  static const Basis constants = Basis::polynomials(1);
  const auto& rows = constants.of(receiver.triangle).points;
  const auto& columns = constants.of(sender.triangle).points;
  Places xs, ys;
  find_places(receiver, rows, xs), find_places(sender, columns, ys);
  float kernel[16], sum = 0;
  sample_kernel(xs, rows.size(), receiver.normal, ys, columns.size(), sender.normal, float(sender.area), kernel);
  for (size_t a = 0; a < rows.size(); ++a)
    for (size_t b = 0; b < columns.size(); ++b)
      sum += float(rows[a].weight * columns[b].weight) * kernel[a * columns.size() + b];
  return sum;
}

}  // namespace

bool turned_away(const TreePatch& a, const TreePatch& b) { return behind(a, b) || behind(b, a); }

bool Transport::near(const TreePatch& a, const TreePatch& b) {
  const float reach = kNear * (a.radius() + b.radius());
  return squared_length(a.middle() - b.middle()) < reach * reach;
}

NodeExchange Transport::sample(const TreePatch& receiver, const TreePatch& sender, float* coefficients) const {
  const ShapeBasis& to = basis_.of(receiver.triangle);
  const ShapeBasis& from = basis_.of(sender.triangle);
  const size_t rows = to.points.size(), columns = from.points.size();
  Places xs, ys;
  find_places(receiver, to.points, xs), find_places(sender, from.points, ys);
  float kernel[kMostPoints * kMostPoints], factors[kMostPoints];
  sample_kernel(xs, rows, receiver.normal, ys, columns, sender.normal, float(sender.area), kernel);
  NodeExchange exchange;
  exchange.spread = range_of(receiver, to.points, xs, sender, from.points, ys, kernel, factors);
  if (near(receiver, sender)) {
    Range range;
    for (size_t a = 0; a < rows; ++a) {
      factors[a] = exact_factor(xs.at(a), receiver.normal, sender);
      range.add(factors[a]);
    }
    range.add(exact_factor(receiver.middle(), receiver.normal, sender));
    exchange.spread = range.size();
  } else if (spread_ == Spread::interpolation) {
    exchange.spread = interpolation_error(receiver, sender, kernel);
  }
  for (size_t a = 0; a < rows; ++a) exchange.factor += float(to.points[a].weight) * factors[a];
  const bool middles_only = to.powers.empty();
  if (middles_only && exchange.factor > 0 && !near(receiver, sender)) {  // of boxes: their mean would be biased
    const float mean = mean_factor(receiver, sender), scale = mean / exchange.factor;
    for (size_t k = 0; k < rows * columns; ++k) kernel[k] *= scale;
    exchange.factor = mean;
  }
  if (coefficients) project(receiver, sender, kernel, coefficients);
  return exchange;
}

float Transport::interpolation_error(const TreePatch& receiver, const TreePatch& sender, const float* kernel) const {
  const ShapeBasis& to = basis_.of(receiver.triangle);
  const ShapeBasis& from = basis_.of(sender.triangle);
  const size_t rows = to.points.size(), columns = from.points.size();
  float worst = 0;
  for (size_t t = 0; t < to.tests.size(); ++t) {
    const Point3 x = receiver.point(float(to.tests[t].x), float(to.tests[t].y));
    float seen[kMostPoints] = {};
    for (size_t a = 0; a < rows; ++a)
      for (size_t b = 0; b < columns; ++b) seen[b] += float(to.received[t * rows + a]) * kernel[a * columns + b];
    for (const size_t s : {size_t(0), 1 + t % (from.tests.size() - 1), 1 + (t + 2) % (from.tests.size() - 1)}) {
      const Point3 y = sender.point(float(from.tests[s].x), float(from.tests[s].y));
      float guess = 0;
      for (size_t b = 0; b < columns; ++b) guess += float(from.sent[s * columns + b]) * seen[b];
      worst = std::max(worst, std::abs(kernel_at(x, receiver.normal, y, sender.normal, float(sender.area)) - guess));
    }
  }
  return worst;
}

/// sum over samples of phi_i weight kernel weight phi_j
void Transport::project(const TreePatch& receiver, const TreePatch& sender, const float* kernel,
                        float* coefficients) const {
  const ShapeBasis& to = basis_.of(receiver.triangle);
  const ShapeBasis& from = basis_.of(sender.triangle);
  const size_t columns = from.points.size();
  for (size_t i = 0; i < to.count; ++i) {
    double seen[kMostPoints] = {};
    for (size_t a = 0; a < to.points.size(); ++a)
      for (size_t b = 0; b < columns; ++b)
        seen[b] += to.points[a].weight * to.values[a * to.count + i] * double(kernel[a * columns + b]);
    for (size_t j = 0; j < from.count; ++j) {
      double sum = 0;
      for (size_t b = 0; b < columns; ++b) sum += seen[b] * from.points[b].weight * from.values[b * from.count + j];
      coefficients[i * from.count + j] = float(sum);
    }
  }
}

void Transport::sample_near(const TreePatch& receiver, const TreePatch& sender, float* coefficients) const {
  collect(receiver, sender, 0, coefficients);
}

void Transport::collect(const TreePatch& receiver, const TreePatch& sender, int depth, float* coefficients) const {
  const ShapeBasis& to = basis_.of(receiver.triangle);
  const ShapeBasis& from = basis_.of(sender.triangle);
  const bool is_near = near(receiver, sender);
  if (!is_near || depth == kDeepest) {
    if (!is_near) return void(sample(receiver, sender, coefficients));
    float kernel[kMostPoints * kMostPoints];
    for (size_t a = 0; a < to.points.size(); ++a)
      std::fill_n(kernel + a * from.points.size(), from.points.size(),
                  exact_factor(receiver.point(float(to.points[a].x), float(to.points[a].y)), receiver.normal, sender));
    return project(receiver, sender, kernel, coefficients);
  }
  std::fill_n(coefficients, to.count * from.count, 0.0f);
  Coefficients part;
  const bool cut_receiver = receiver.area >= sender.area;
  for (int c = 0; c < 4; ++c) {
    collect(cut_receiver ? receiver.quarter(c) : receiver, cut_receiver ? sender : sender.quarter(c), depth + 1,
            part.data());
    const auto& push = cut_receiver ? to.push[size_t(c)] : from.push[size_t(c)];
    for (size_t i = 0; i < to.count; ++i)
      for (size_t j = 0; j < from.count; ++j) {
        double sum = 0;
        if (cut_receiver)
          for (size_t k = 0; k < to.count; ++k) sum += push[i * to.count + k] / 4 * double(part[k * from.count + j]);
        else
          for (size_t k = 0; k < from.count; ++k) sum += push[j * from.count + k] * double(part[i * from.count + k]);
        coefficients[i * from.count + j] += float(sum);
      }
  }
}

float look_between(const TreePatch& receiver, const TreePatch& sender, int rays, uint32_t seed,
                   const Visibility& visibility, VisibilityQueue& queue, uint32_t owner) {
  float weights = 0;
  const uint32_t other = hash32(seed);
  for (int k = 0; k < rays; ++k) {
    const Point3 x = receiver.place(sobol_owen(uint32_t(k), seed)), y = sender.place(sobol_owen(uint32_t(k), other));
    const Vec3 d = y - x;
    const float cosines = std::max(0.0f, dot(receiver.normal, d)) * std::max(0.0f, -dot(sender.normal, d));
    if (!(cosines > 0)) continue;
    const float squared = squared_length(d), weight = cosines / (squared * squared);
    weights += weight;
    queue.add(visibility.between(x, receiver.normal, y, sender.normal), owner, weight);
  }
  return weights;
}

}  // namespace aktina
