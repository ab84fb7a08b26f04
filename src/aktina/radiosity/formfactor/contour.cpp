// Both integrals around the contours in closed form; what occluders hide is cut out exactly at each point and
// integrated adaptively. Accuracy: 1e-13 unoccluded, `tolerance` otherwise. Cost: about 10 us a visible pair,
// milliseconds an occluded one. Weakness: that cost; where many shadows overlap it may stop before the tolerance, and
// says so in its error.
//
// P. Schroeder, P. Hanrahan, "On the Form Factor between Two Polygons", SIGGRAPH '93.
#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/formfactor/occluded.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"

namespace aktina {
namespace {

class ContourMethod final : public FormFactorMethod {
 public:
  explicit ContourMethod(double tolerance) : tolerance_(tolerance) {}

  void build(const FormFactorScene& scene) override { faces_ = Faces(scene); }

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    const Face& a = faces_[i];
    FormFactorRow row;
    for (size_t j = 0; j < faces_.size(); ++j) {
      const Estimate e = i == j ? Estimate{0, 0} : exchange_area(a, faces_[j], faces_.blockers(i, j), tolerance_);
      row.factors.push_back(e.value / a.area), row.errors.push_back(e.error / a.area);
    }
    return row;
  }

  FormFactorRow row(Point3d x, Vec3d n) const override { return point_to_polygons(x, n, faces_); }

 private:
  double tolerance_;
  Faces faces_;
};

constexpr Param kParams[] = {
    {"tolerance", "1", "wanted absolute error of a form factor past occluders", 1e-8, 1e-12, 1}};

}  // namespace

extern constinit const FormFactorMethodRow contour_formfactor = {
    {"contour", "Exact polygon to polygon", "schroder1993",
     "Contour integrals in closed form, occluders cut out exactly: the reference for all others; microseconds a "
     "visible "
     "pair, milliseconds an occluded one.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return std::make_unique<ContourMethod>(params["tolerance"]);
    }};

}  // namespace aktina
