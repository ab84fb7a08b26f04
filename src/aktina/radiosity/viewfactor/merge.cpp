#include "aktina/radiosity/viewfactor/merge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "aktina/radiosity/viewfactor/welder.h"

namespace aktina {
namespace {

constexpr double kSameArea = 1e-9;  // relative

struct FlatPoint {
  double u, v;
  Point3d p;
};

double turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/// A. Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", Inf. Proc. Letters 9, 1979.
std::vector<FlatPoint> convex_hull(std::vector<FlatPoint> points, double flat) {
  std::sort(points.begin(), points.end(),
            [](const FlatPoint& a, const FlatPoint& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  std::vector<FlatPoint> hull;
  const auto chain = [&](auto begin, auto end) {
    const size_t base = hull.size();
    for (auto it = begin; it != end; ++it) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), *it) <= flat) hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

std::vector<FlatPoint> flattened(const std::vector<const Face*>& facets) {
  const Vec3d n = facets[0]->plane.normal;
  const Vec3d u = normalize(cross(std::abs(n.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0), n)), v = cross(n, u);
  const Point3d origin = facets[0]->vertices[0];
  std::vector<FlatPoint> points;
  for (const Face* facet : facets)
    for (const Point3d& p : facet->vertices) points.push_back({dot(p - origin, u), dot(p - origin, v), p});
  return points;
}

/// The convex outline of the facets, where they fill it.
Contour convex_outline(const std::vector<const Face*>& facets, double tolerance) {
  double area = 0;
  for (const Face* facet : facets) area += facet->area;
  const std::vector<FlatPoint> hull = convex_hull(flattened(facets), tolerance * std::sqrt(area));
  double twice = 0;
  for (size_t i = 2; i < hull.size(); ++i) twice += turn(hull[0], hull[i - 1], hull[i]);
  if (std::abs(0.5 * twice - area) > kSameArea * area || hull.size() > kMostCorners) return {};
  Contour outline;
  for (const FlatPoint& p : hull) outline.push_back(p.p);
  return outline;
}

/// A convex polygon with as many cuts as its corners ask for.
void add(const Contour& piece, const Plane& plane, std::vector<ConvexPolygon>& polygons) {
  for (size_t first = 1; first + 1 < piece.size(); first += kMostCorners - 2) {
    Contour part{piece[0]};
    for (size_t k = first; k < std::min(first + kMostCorners - 1, piece.size()); ++k) part.push_back(piece[k]);
    polygons.push_back({std::move(part), plane});
  }
}

}  // namespace

std::vector<ConvexPolygon> merge_coplanar(const std::vector<const Face*>& facets, double tolerance,
                                          std::vector<uint32_t>& groups) {
  // Planes by rounding: two facets of one plane may fall into different cells, which only costs speed.
  std::map<std::array<int64_t, 4>, std::vector<uint32_t>> planes;
  const auto cell = [](double x, double size) { return int64_t(std::llround(x / size)); };
  for (uint32_t i = 0; i < facets.size(); ++i) {
    const Plane& plane = facets[i]->plane;
    planes[{cell(plane.normal.x, 1e-6), cell(plane.normal.y, 1e-6), cell(plane.normal.z, 1e-6),
            cell(dot(plane.normal, plane.point), 4 * tolerance)}]
        .push_back(i);
  }
  Welder welder(tolerance);
  std::vector<ConvexPolygon> result;
  groups.assign(facets.size(), 0);
  uint32_t group = 0;
  for (const auto& [key, members] : planes) {
    DisjointSets sets(members.size());
    std::map<uint32_t, size_t> first;  // facet at each vertex
    for (size_t k = 0; k < members.size(); ++k)
      for (const Point3d& p : facets[members[k]]->vertices) {
        const auto [at, fresh] = first.try_emplace(welder.id(p), k);
        if (!fresh) sets.join(k, at->second);
      }
    std::map<size_t, std::vector<uint32_t>> parts;
    for (size_t k = 0; k < members.size(); ++k) parts[sets.find(k)].push_back(members[k]);
    for (const auto& [root, part] : parts) {
      std::vector<const Face*> list;
      for (const uint32_t i : part) list.push_back(facets[i]), groups[i] = group;
      ++group;
      if (Contour outline = convex_outline(list, tolerance); !outline.empty()) {
        result.push_back({std::move(outline), list[0]->plane});
        continue;
      }
      for (const Face* face : list)
        for (const Contour& piece : face->convex) add(piece, face->plane, result);
    }
  }
  return result;
}

}  // namespace aktina
