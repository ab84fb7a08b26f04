#include "aktina/radiosity/lightmap/given_uv.h"

#include <cmath>
#include <numeric>

namespace aktina {
namespace {

constexpr float kBeyond = 1e-4f;  // rounding that is forgiven
constexpr float kNoArea = 1e-12f;

bool in_unit_square(const FlatTriangle& t) {
  for (const Vec2 p : t)
    if (!(p.x >= -kBeyond && p.x <= 1 + kBeyond && p.y >= -kBeyond && p.y <= 1 + kBeyond)) return false;
  return true;
}

/// Why the coordinates cannot be used; null: they can.
const char* fault(const LightmapSurface& s) {
  for (const FlatTriangle& t : s.given)
    if (!in_unit_square(t)) return "second texture coordinates of a surface leave [0, 1]: charts were made instead";
  for (const FlatTriangle& t : s.given)
    if (!(std::fabs(twice_area(t)) > kNoArea))
      return "second texture coordinates of a surface give triangles no area: charts were made instead";
  const FlatOverlap overlap = flat_overlap(s.given);
  if (!overlap.known || overlap.count > 0)
    return "second texture coordinates of a surface overlap: charts were made instead";
  return nullptr;
}

}  // namespace

Chart given_chart(const LightmapSurface& surface, Warnings& warnings) {
  Chart chart;
  if (surface.given.empty()) return chart;
  if (const char* const reason = fault(surface)) {
    warnings.add(reason);
    return chart;
  }
  double flat = 0;
  for (const FlatTriangle& t : surface.given) flat += 0.5 * std::fabs(double(twice_area(t)));
  const auto metres = float(std::sqrt(surface.area() / flat));
  chart.triangles.resize(surface.size());
  std::iota(chart.triangles.begin(), chart.triangles.end(), 0u);
  for (const FlatTriangle& t : surface.given) chart.corners.push_back({t[0] * metres, t[1] * metres, t[2] * metres});
  settle(chart);
  return chart;
}

bool share_a_page(const std::vector<LightmapSurface>& surfaces) {
  std::vector<FlatTriangle> all;
  for (const LightmapSurface& s : surfaces) {
    if (s.given.empty() || s.back) return false;
    all.insert(all.end(), s.given.begin(), s.given.end());
  }
  for (const FlatTriangle& t : all)
    if (!in_unit_square(t) || !(std::fabs(twice_area(t)) > kNoArea)) return false;
  const FlatOverlap overlap = flat_overlap(all);
  return overlap.known && overlap.count == 0;
}

}  // namespace aktina
