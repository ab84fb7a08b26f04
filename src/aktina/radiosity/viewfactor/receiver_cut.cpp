#include "aktina/radiosity/viewfactor/receiver_cut.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr size_t kMostPieces = 16;
constexpr double kDrawnIn =
    1e-5;  // of the blocker: faces are drawn in by less, and so may end above what they stand on

struct Range {
  double low = INFINITY, high = -INFINITY;
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
};

/// Where a polygon meets a plane, along a direction in both.
Range meeting(const Contour& polygon, const Plane& plane, Vec3d along, double margin) {
  Range range;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Point3d p = polygon[k], q = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    const double a = plane.height(p), b = plane.height(q);
    if (std::abs(a) <= margin) range.add(dot(along, p));
    if ((a > margin && b < -margin) || (a < -margin && b > margin)) range.add(dot(along, p + a / (a - b) * (q - p)));
  }
  return range;
}

/// Both parts of a piece that reaches to both sides; else it stays whole.
void split(const Plane& plane, double tolerance, size_t at, std::vector<Contour>& pieces) {
  Contour front = clip(pieces[at], plane, tolerance);
  Contour back = clip(pieces[at], {plane.point, -plane.normal}, tolerance);
  if (front.size() < 3 || back.size() < 3) return;
  pieces[at] = std::move(front);
  pieces.push_back(std::move(back));
}

}  // namespace

void cut_where_met(const Blocker& blocker, const Plane& receiver, double tolerance, std::vector<Contour>& pieces) {
  for (const Contour& face : blocker.faces) {
    Vec3d normal(0);
    for (size_t k = 2; k < face.size(); ++k) normal += cross(face[k - 1] - face[0], face[k] - face[0]);
    const Plane plane{face[0], normalize(normal)};
    const Vec3d along = cross(plane.normal, receiver.normal);
    if (!(squared_length(along) > 1e-12)) continue;
    const Range own = meeting(face, receiver, along, kDrawnIn * blocker.radius);
    for (size_t k = pieces.size(); k-- > 0 && pieces.size() < kMostPieces;) {
      const Range its = meeting(pieces[k], plane, along, tolerance);
      if (std::min(own.high, its.high) - std::max(own.low, its.low) > tolerance) split(plane, tolerance, k, pieces);
    }
  }
}

}  // namespace aktina
