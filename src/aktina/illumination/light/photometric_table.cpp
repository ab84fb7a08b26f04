#include "aktina/illumination/light/photometric_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {
namespace {

/// Between which two angles a value lies, and how far: 0 at `low`, 1 at `high`.
struct Between {
  size_t low, high;
  float t;
};

Between find(const std::vector<float>& angles, float value) {
  const auto above = std::upper_bound(angles.begin(), angles.end(), value);
  if (above == angles.begin()) return {0, 0, 0};
  const auto high = size_t(above - angles.begin());
  if (high == angles.size()) return {high - 1, high - 1, 0};
  return {high - 1, high, (value - angles[high - 1]) / (angles[high] - angles[high - 1])};
}

double cosine(float degrees) { return std::cos(double(degrees) * kPi / 180); }

/// Integral of I over the cosine of gamma in one plane: the zonal sum of photometry.
double plane_integral(const PhotometricTable& table, size_t plane) {
  const float* candela = &table.candela[plane * table.gamma.size()];
  double sum = 0;
  for (size_t i = 0; i + 1 < table.gamma.size(); ++i)
    sum += (double(candela[i]) + double(candela[i + 1])) / 2 * (cosine(table.gamma[i]) - cosine(table.gamma[i + 1]));
  return sum;
}

[[noreturn]] void fail(std::string what) { throw Error(Code::bad_param, "photometric table", std::move(what)); }

void check_angles(const std::vector<float>& angles, const char* name, float most) {
  if (angles.empty()) fail(fmt::format("has no {} angles", name));
  for (size_t i = 0; i < angles.size(); ++i) {
    if (!(angles[i] >= 0 && angles[i] <= most))
      fail(fmt::format("{} angle {} is {} degrees, not within 0 .. {}", name, i + 1, angles[i], most));
    if (i > 0 && !(angles[i] > angles[i - 1]))
      fail(fmt::format("{} angle {} ({} degrees) is not above the one before it ({})", name, i + 1, angles[i],
                       angles[i - 1]));
  }
}

}  // namespace

void check(const PhotometricTable& table) {
  check_angles(table.c, "C", 360);
  check_angles(table.gamma, "gamma", 180);
  if (table.c.front() != 0 || (table.c.size() > 1 && table.c.back() != 360)) fail("C angles do not run from 0 to 360");
  if (table.gamma.size() < 2) fail("has fewer than two gamma angles");
  if (table.candela.size() != table.c.size() * table.gamma.size())
    fail(fmt::format("has {} intensities for {} x {} directions", table.candela.size(), table.c.size(),
                     table.gamma.size()));
  for (const float value : table.candela)
    if (!(value >= 0) || !std::isfinite(value)) fail(fmt::format("has an intensity of {} cd", value));
}

float intensity(const PhotometricTable& table, float c, float gamma) {
  if (gamma < table.gamma.front() || gamma > table.gamma.back()) return 0;
  Between g = find(table.gamma, gamma);
  const Between p = find(table.c, c);
  if (g.low != g.high) {
    const double low = cosine(table.gamma[g.low]), high = cosine(table.gamma[g.high]);
    g.t = float((low - cosine(gamma)) / (low - high));
  }
  const auto at = [&](size_t plane) {
    const float* candela = &table.candela[plane * table.gamma.size()];
    return candela[g.low] + (candela[g.high] - candela[g.low]) * g.t;
  };
  return at(p.low) + (at(p.high) - at(p.low)) * p.t;
}

float intensity(const PhotometricTable& table, Vec3 axis, Vec3 c0, Vec3 direction) {
  const float x = dot(direction, c0), y = dot(direction, cross(c0, axis)), z = dot(direction, axis);
  constexpr auto kDegrees = float(180 / kPi);
  const float gamma = std::atan2(std::sqrt(x * x + y * y), z) * kDegrees, c = std::atan2(y, x) * kDegrees;
  return intensity(table, c < 0 ? c + 360 : c, std::fmin(gamma, 180.0f));
}

double flux(const PhotometricTable& table) {
  if (table.c.size() == 1) return 2 * kPi * plane_integral(table, 0);
  double sum = 0, before = plane_integral(table, 0);
  for (size_t i = 1; i < table.c.size(); ++i) {  // linear between planes: the trapezoidal rule is exact
    const double here = plane_integral(table, i);
    sum += (before + here) / 2 * double(table.c[i] - table.c[i - 1]) * kPi / 180;
    before = here;
  }
  return sum;
}

PeakIntensity peak(const PhotometricTable& table) {
  const auto most = size_t(std::max_element(table.candela.begin(), table.candela.end()) - table.candela.begin());
  return {table.candela[most], table.c[most / table.gamma.size()], table.gamma[most % table.gamma.size()]};
}

}  // namespace aktina
