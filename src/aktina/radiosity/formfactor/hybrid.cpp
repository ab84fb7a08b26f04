// All pairs at once, each by the cheapest way that meets the target: Gauss points with Lambert's closed form where
// patches are apart, both contours in closed form where they are near; blockers merged into convex bodies, pairs behind
// or beside them sorted out by planes, shadows cut out exactly at points of an adaptive grid, rays where many shadows
// overlap. Cost: 20 ns a visible pair, microseconds one with a shadow's edge. Weakness: the whole matrix is made when
// the first row is wanted, and kept.
//
// G. Walton, "Calculation of Obstructed View Factors by Adaptive Integration", NISTIR 6925, 2002 (the peer that it is
// measured against); D. Baum, H. Rushmeier, J. Winget, SIGGRAPH '89; P. Schroeder, P. Hanrahan, SIGGRAPH '93.
#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/formfactor/point_to_polygon.h"
#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {
namespace {

class Hybrid final : public FormFactorMethod {
 public:
  explicit Hybrid(double target) : target_(target) {}

  void build(const FormFactorScene& scene) override {
    faces_ = Faces(scene);
    ViewFactorScene all{scene.surfaces, {}, {}, scene.occluders, {}, {}, {}};
    for (uint32_t i = 0; i < scene.surfaces.size(); ++i) all.owners.push_back(i), all.names.emplace_back();
    factors_ = view_factors(all, {.target_error = target_});
  }

  FormFactorRow row(size_t i) const override {
    check_surface(faces_, i);
    const ViewFactors& f = factors_;
    FormFactorRow row{std::vector<double>(f.size(), 0), std::vector<double>(f.size(), 0)};
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k)
      row.factors[f.columns[k]] = f.factors[k], row.errors[f.columns[k]] = double(f.errors[k]);
    return row;
  }

  FormFactorRow row(Point3d x, Vec3d n) const override { return point_to_polygons(x, n, faces_); }

 private:
  double target_;
  Faces faces_;
  ViewFactors factors_;
};

constexpr Param kParams[] = {{"target_error", "1", "wanted absolute error of each factor", 1e-4, 1e-8, 0.1}};

}  // namespace

extern constinit const FormFactorMethodRow hybrid_formfactor = {
    {"hybrid", "Hybrid that meets a target error", "walton2002",
     "Each pair by the cheapest way that is accurate enough, shadows cut out exactly: what aktina viewfactors uses; "
     "the "
     "whole matrix at once.",
     kParams},
    [](const ParamSet& params) -> std::unique_ptr<FormFactorMethod> {
      return std::make_unique<Hybrid>(params["target_error"]);
    }};

}  // namespace aktina
