#include "aktina/radiosity/formfactor/occluded.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/adaptive_triangles.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "aktina/radiosity/formfactor/polygon_to_polygon.h"
#include "aktina/radiosity/formfactor/quadrature.h"
#include "aktina/radiosity/formfactor/shadow.h"

namespace aktina {
namespace {

constexpr size_t kMostCells = 400;      // cutting along lines stops there
constexpr size_t kMostPlanes = 600;     // and is not begun where there are more lines
constexpr size_t kMostPoints = 400000;  // of the receiver, for one pair
constexpr size_t kFewCells = 64;        // that are not cut along all lines: halved until there are more
constexpr double kExact = 1e-13;        // error of the closed form, of the smaller area

/// All that the integration over the receiver needs.
struct Pair {
  Plane receiver;
  std::vector<Contour> cells, sources, occluders;
  double margin;
};

std::vector<Contour> clip_all(std::span<const Contour> pieces, const Plane& plane, double margin) {
  std::vector<Contour> kept;
  for (const Contour& piece : pieces)
    if (Contour part = clip(piece, plane, margin); !part.empty()) kept.push_back(std::move(part));
  return kept;
}

/// Whether a plane through an edge of `a` and a corner of `b` has both on one side and the occluder on the other.
bool parted(const Contour& occluder, const Contour& a, const Contour& b, double margin) {
  for (size_t i = 0; i < a.size(); ++i)
    for (const Point3d& corner : b) {
      Vec3d normal = cross(a[(i + 1) % a.size()] - a[i], corner - a[i]);
      if (const double norm = length(normal); norm > 0)
        normal /= norm;
      else
        continue;
      double low = 0, high = 0, low_occluder = INFINITY, high_occluder = -INFINITY;
      const Plane plane{a[i], normal};
      for (const Contour* contour : {&a, &b})
        for (const Point3d& p : *contour) low = std::min(low, plane.height(p)), high = std::max(high, plane.height(p));
      for (const Point3d& p : occluder) {
        low_occluder = std::min(low_occluder, plane.height(p));
        high_occluder = std::max(high_occluder, plane.height(p));
      }
      if ((low >= -margin && high_occluder <= margin) || (high <= margin && low_occluder >= -margin)) return true;
    }
  return false;
}

/// Whether one convex piece blocks all lines between corners, and so, being convex, all lines.
bool hides_all(const Contour& occluder, const Contour& a, const Contour& b) {
  const Vec3d normal = cross(occluder[1] - occluder[0], occluder[2] - occluder[0]);
  for (const Point3d& p : a)
    for (const Point3d& q : b) {
      const double above = dot(normal, p - occluder[0]), below = dot(normal, q - occluder[0]);
      if (!(above * below < 0)) return false;
      const Point3d x = p + above / (above - below) * (q - p);
      for (size_t i = 0; i < occluder.size(); ++i)
        if (!(dot(normal, cross(occluder[(i + 1) % occluder.size()] - occluder[i], x - occluder[i])) > 0)) return false;
    }
  return true;
}

/// Planes of sight that cut the receiver, each once.
class CriticalPlanes {
 public:
  explicit CriticalPlanes(const Pair& pair) : pair_(pair) {
    for (const Contour& occluder : pair.occluders) {
      add({occluder[0], cross(occluder[1] - occluder[0], occluder[2] - occluder[0])});
      for (const Contour& source : pair.sources) add(occluder, source), add(source, occluder);
    }
    for (const Contour& one : pair.occluders)
      for (const Contour& other : pair.occluders)
        if (&one != &other) add(one, other);
  }

  /// Empty where there are too many.
  const std::vector<Plane>& planes() const { return planes_; }
  bool complete() const { return !too_many_; }

 private:
  void add(const Contour& edges, const Contour& corners) {
    for (size_t i = 0; i < edges.size(); ++i)
      for (const Point3d& corner : corners)
        add({corner, cross(edges[(i + 1) % edges.size()] - edges[i], corner - edges[i])});
  }

  void add(Plane plane) {
    const double norm = length(plane.normal);
    if (too_many_ || !(norm > 0)) return;
    plane.normal /= norm;
    bool front = false, back = false;
    for (const Contour& cell : pair_.cells)
      for (const Point3d& p : cell) {
        const double height = plane.height(p);
        front = front || height > pair_.margin, back = back || height < -pair_.margin;
      }
    if (!front || !back || known(plane)) return;
    planes_.push_back(plane);
    if (planes_.size() <= kMostPlanes) return;
    too_many_ = true;
    planes_.clear();
  }

  /// Whether a plane of the list meets the receiver in the same line.
  bool known(const Plane& plane) const {
    const Vec3d along = cross(plane.normal, pair_.receiver.normal);
    const Point3d corner = pair_.cells[0][0];
    return std::any_of(planes_.begin(), planes_.end(), [&](const Plane& other) {
      const Vec3d along_other = cross(other.normal, pair_.receiver.normal);
      return length(cross(along, along_other)) < 1e-12 &&
             std::abs(plane.height(corner) / length(along) -
                      std::copysign(1.0, dot(along, along_other)) * other.height(corner) / length(along_other)) <
                 pair_.margin;
    });
  }

  const Pair& pair_;
  std::vector<Plane> planes_;
  bool too_many_ = false;
};

/// Whether the cells are what the integrand is smooth in.
bool cut_cells(Pair& pair) {
  std::vector<Contour> cut;
  const CriticalPlanes critical(pair);
  for (const Plane& plane : critical.planes()) {
    if (pair.cells.size() > kMostCells) return false;
    cut.clear();
    for (Contour& cell : pair.cells) {
      Contour front = clip(cell, plane, pair.margin), back = clip(cell, {plane.point, -plane.normal}, pair.margin);
      if (front.empty() || back.empty()) {
        cut.push_back(std::move(cell));
      } else {
        cut.push_back(std::move(front)), cut.push_back(std::move(back));
      }
    }
    pair.cells.swap(cut);
  }
  return critical.complete();
}

/// What is hidden, integrated over the receiver.
struct HiddenArea {
  Estimate hidden;
  bool anything_visible;
};

/// @param halvings  of each triangle before its error is believed
HiddenArea hidden_area(const Pair& pair, double tolerance, int halvings) {
  size_t points = 0;
  bool visible = false;
  const auto gauss = [&](const Triangle& triangle, int n) {
    double sum = 0;
    for (const SurfaceSample& s : gauss_points(triangle, pair.receiver.normal, n)) {
      const VisiblePart part = visible_part(s.x, pair.receiver.normal, pair.sources, pair.occluders, pair.margin);
      visible = visible || part.visible > 0;
      sum += s.area * part.hidden, ++points;
    }
    return sum;
  };
  const auto rule = [&](const Triangle& triangle) {
    const double coarse = gauss(triangle, 3), fine = gauss(triangle, 5);
    return Estimate{fine, std::abs(fine - coarse)};
  };
  AdaptiveTriangles triangles(rule);
  for (const Contour& cell : pair.cells)
    for (size_t i = 1; i + 1 < cell.size(); ++i) triangles.add({cell[0], cell[i], cell[i + 1]}, halvings);
  triangles.refine(tolerance, [&] { return points < kMostPoints; });
  return {triangles.sum(), visible};
}

Pair make_pair(const Face& receiver, const Face& source, std::vector<Contour> occluders, double margin) {
  return {receiver.plane, clip_all(receiver.convex, source.plane, margin),
          clip_all(source.convex, receiver.plane, margin), std::move(occluders), margin};
}

}  // namespace

double clearance(const Face& face, std::span<const Contour> occluders) {
  double nearest = INFINITY;
  for (const Contour& occluder : occluders)
    for (const Point3d& p : occluder) {
      const double height = face.plane.height(p);
      const double beside = std::sqrt(std::max(squared_length(p - face.centre) - height * height, 0.0)) - face.radius;
      nearest = std::min(nearest, std::hypot(height, std::max(beside, 0.0)));
    }
  return nearest;
}

bool may_hide(const Face& occluder, const Face& a, const Face& b) {
  // Within the capsule around both bounding spheres?
  const Vec3d axis = b.centre - a.centre, to = occluder.centre - a.centre;
  const double squared = squared_length(axis), t = squared > 0 ? std::clamp(dot(to, axis) / squared, 0.0, 1.0) : 0;
  const double reach = std::max(a.radius, b.radius) + occluder.radius;
  if (squared_length(to - t * axis) > reach * reach) return false;
  return a.plane.height(occluder.centre) > -occluder.radius && b.plane.height(occluder.centre) > -occluder.radius;
}

Estimate exchange_area(const Face& a, const Face& b, std::span<const Face* const> occluders, double tolerance) {
  const FacingParts parts = facing_parts(a, b);
  const double unoccluded = exchange_area(a, b, parts.a, parts.b);
  const double rest = kExact * std::min(a.area, b.area);
  if (unoccluded == 0) return {0, 0};

  const double margin = std::max(rounding(a), rounding(b));
  std::vector<Contour> blocking;
  for (const Face* occluder : occluders)
    if (may_hide(*occluder, a, b))
      for (Contour& piece : between(*occluder, a.plane, b.plane, margin)) {
        if (parted(piece, parts.a, parts.b, margin) || parted(piece, parts.b, parts.a, margin)) continue;
        if (hides_all(piece, parts.a, parts.b)) return {0, 0};
        blocking.push_back(std::move(piece));
      }
  if (blocking.empty()) return {unoccluded, rest};

  // The receiver is the face farther from the occluders: near them the shadow's edge is sharp.
  const double from_a = clearance(a, blocking), from_b = clearance(b, blocking);
  const bool a_receives = from_a != from_b ? from_a > from_b : a.radius <= b.radius;
  Pair pair = a_receives ? make_pair(a, b, std::move(blocking), margin) : make_pair(b, a, std::move(blocking), margin);
  int halvings = 0;
  if (!cut_cells(pair))
    while (pair.cells.size() << halvings < kFewCells) ++halvings;
  const HiddenArea area = hidden_area(pair, tolerance * a.area, halvings);
  if (!area.anything_visible) return {0, area.hidden.error};
  return {std::clamp(unoccluded - area.hidden.value, 0.0, unoccluded), area.hidden.error + rest};
}

}  // namespace aktina
