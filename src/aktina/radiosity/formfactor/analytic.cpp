// The form factor from a point to a polygon in closed form (Lambert), averaged over Gauss points of the receiver;
// occluders are cut out exactly at each point. Cost: 0.1 us a point and polygon, a few more for each occluder in the
// way. Weakness: few points miss what changes quickly over the receiver: patches that touch, edges of shadows.
//
// D. Baum, H. Rushmeier, J. Winget, "Improving Radiosity Solutions Through the Use of Analytically Determined
// Form-Factors", SIGGRAPH '89.
#include <cmath>

#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/formfactor/occluded.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {
namespace {

class Analytic final : public FormFactorMethod {
 public:
  explicit Analytic(int points) : points_(points) {}

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
  /// The receiver is cut by the plane of the source, so that the integrand does not end within a piece.
  double mean(const Face& a, const Face& b, std::span<const Face* const> occluders, int n) const {
    double sum = 0;
    for (const Contour& piece : a.convex)
      for (const SurfaceSample& s : gauss_points(clip(piece, b.plane, rounding(b)), a.plane.normal, n))
        sum += s.area * point_to_polygon(s.x, a.plane.normal, b, occluders);
    return sum / a.area;
  }

  Estimate pair(size_t i, size_t j) const {
    const Face &a = faces_[i], &b = faces_[j];
    if (a.plane.height(b.centre) <= -b.radius || b.plane.height(a.centre) <= -a.radius) return {0, 0};
    std::vector<const Face*> occluders;
    for (const Face* face : faces_.blockers(i, j))
      if (may_hide(*face, a, b)) occluders.push_back(face);
    const double fine = mean(a, b, occluders, points_), coarse = mean(a, b, occluders, (points_ + 1) / 2);
    return {fine, std::abs(fine - coarse)};
  }

  int points_;
  Faces faces_;
};

constexpr Param kParams[] = {
    {"points", "1", "Gauss points on each axis of each triangle of the receiver", 6, 2, 32, true}};

}  // namespace

extern constinit const FormFactorMethodRow analytic_formfactor = {
    {"analytic", "Analytic from points to polygons", "baum1989",
     "Lambert's closed form from Gauss points of the receiver, occluders cut out exactly: accurate for patches that do "
     "not touch.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return std::make_unique<Analytic>(int(params["points"]));
    }};

}  // namespace aktina
