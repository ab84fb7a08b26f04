#include "aktina/radiosity/formfactor/adaptive_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aktina {
namespace {

constexpr double kDoubt = 0.25;

/// Across the longest edge.
std::pair<Triangle, Triangle> halves(const Triangle& t) {
  const auto edge = [&](size_t k) { return squared_length(t[(k + 1) % 3] - t[k]); };
  const size_t longest = edge(0) >= edge(1) && edge(0) >= edge(2) ? 0 : edge(1) >= edge(2) ? 1 : 2;
  const Point3d a = t[longest], b = t[(longest + 1) % 3], tip = t[(longest + 2) % 3], middle = 0.5 * (a + b);
  return {{a, middle, tip}, {middle, b, tip}};
}

}  // namespace

void AdaptiveTriangles::push(const Part& part) {
  error_ += part.integral.error;
  parts_.push_back(part);
  std::push_heap(parts_.begin(), parts_.end());
}

void AdaptiveTriangles::add(const Triangle& triangle, int halvings) {
  if (halvings == 0) return push({triangle, rule_(triangle)});
  const auto [first, second] = halves(triangle);
  add(first, halvings - 1), add(second, halvings - 1);
}

void AdaptiveTriangles::refine(double tolerance, FunctionRef<bool()> more) {
  while (error_ > tolerance && more()) {
    std::pop_heap(parts_.begin(), parts_.end());
    const Part worst = parts_.back();
    parts_.pop_back();
    error_ -= worst.integral.error;
    const auto [a, b] = halves(worst.triangle);
    Part first{a, rule_(a)}, second{b, rule_(b)};
    const double moved = kDoubt * std::abs(first.integral.value + second.integral.value - worst.integral.value);
    for (Part* half : {&first, &second}) half->integral.error = std::max(half->integral.error, moved), push(*half);
  }
}

Estimate AdaptiveTriangles::sum() const {
  Estimate sum{0, 0};
  for (const Part& part : parts_) sum.value += part.integral.value, sum.error += part.integral.error;
  return sum;
}

}  // namespace aktina
