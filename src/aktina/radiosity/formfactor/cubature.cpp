// Adaptive cubature from area to area: the closed form from a point to a polygon (Lambert), occluders cut out exactly,
// integrated over triangles of the face that is farther from the occluders; the triangle of the largest error is halved
// until the sum of the errors meets the tolerance. Cost: grows with the edges of shadows and with what touches, not
// with smooth factors; it stops after 100,000 points, and reports the error that is left then. Weakness: a shadow
// narrower than the first points' distance is found by luck.
//
// Worst triangle first: P. van Dooren, L. de Ridder, "An Adaptive Algorithm for Numerical Integration over an
// n-Dimensional Cube", J. Computational and Applied Mathematics 2, 1976; of form factors: G. Walton, "Calculation of
// Obstructed View Factors by Adaptive Integration", NISTIR 6925, 2002.
#include <cmath>

#include "aktina/radiosity/formfactor/adaptive_triangles.h"
#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/formfactor/occluded.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "aktina/radiosity/formfactor/quadrature.h"
#include "aktina/radiosity/formfactor/shadow.h"

namespace aktina {
namespace {

constexpr int kCoarse = 2, kFine = 3;  // Gauss points on each axis of a triangle
constexpr int kFirstHalvings = 3;      // of every triangle
constexpr size_t kMostPoints = 100'000;

/// A_i F_ij. @param tolerance  of it, m^2
Estimate integral(const Face& receiver, const Face& source, std::span<const Face* const> occluders, double tolerance) {
  size_t points = 0;
  const auto over = [&](const Triangle& triangle, int n) {
    double sum = 0;
    for (const SurfaceSample& s : gauss_points(triangle, receiver.plane.normal, n))
      sum += s.area * point_to_polygon(s.x, receiver.plane.normal, source, occluders), ++points;
    return sum;
  };
  const auto rule = [&](const Triangle& triangle) {
    const double fine = over(triangle, kFine);
    return Estimate{fine, std::abs(fine - over(triangle, kCoarse))};
  };
  AdaptiveTriangles triangles(rule);
  for (const Contour& piece : receiver.convex) {
    const Contour facing = clip(piece, source.plane, rounding(source));
    for (size_t k = 1; k + 1 < facing.size(); ++k) triangles.add({facing[0], facing[k], facing[k + 1]}, kFirstHalvings);
  }
  triangles.refine(tolerance, [&] { return points < kMostPoints; });
  return triangles.sum();
}

class Cubature final : public FormFactorMethod {
 public:
  explicit Cubature(double tolerance) : tolerance_(tolerance) {}

  void build(const FormFactorScene& scene) override { faces_ = Faces(scene); }

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    FormFactorRow row;
    for (size_t j = 0; j < faces_.size(); ++j) {
      const Estimate e = i == j ? Estimate{0, 0} : pair(i, j);
      row.factors.push_back(e.value), row.errors.push_back(e.error);
    }
    return row;
  }

  FormFactorRow row(Point3d x, Vec3d n) const override { return point_to_polygons(x, n, faces_); }

 private:
  Estimate pair(size_t i, size_t j) const {
    const Face &a = faces_[i], &b = faces_[j];
    if (a.plane.height(b.centre) <= -b.radius || b.plane.height(a.centre) <= -a.radius) return {0, 0};
    std::vector<const Face*> occluders;
    std::vector<Contour> pieces;
    for (const Face* face : faces_.blockers(i, j)) {
      if (!may_hide(*face, a, b)) continue;
      occluders.push_back(face);
      for (Contour& piece : between(*face, a.plane, b.plane, rounding(a))) pieces.push_back(std::move(piece));
    }
    // Over the smaller face, which the other one changes least on; where something hides, over the one farther from it.
    const bool over_a = pieces.empty() ? a.area <= b.area : clearance(a, pieces) >= clearance(b, pieces);
    const double tolerance = tolerance_ * a.area;
    const Estimate e = over_a ? integral(a, b, occluders, tolerance) : integral(b, a, occluders, tolerance);
    return {e.value / a.area, e.error / a.area};
  }

  double tolerance_;
  Faces faces_;
};

constexpr Param kParams[] = {
    {"tolerance", "1", "absolute error of a factor at which subdivision stops", 1e-5, 1e-9, 0.1}};

}  // namespace

extern constinit const FormFactorMethodRow cubature_formfactor = {
    {"cubature", "Adaptive cubature from area to area", "walton2002",
     "Lambert's closed form integrated over triangles of the receiver, halved where it changes; occluders cut out "
     "exactly.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return std::make_unique<Cubature>(params["tolerance"]);
    }};

}  // namespace aktina
