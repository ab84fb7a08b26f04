// White furnaces: where light comes from everywhere, what is reflected is known exactly.
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/illumination/model.h"
#include "aktina/render/validate_cases.h"

namespace aktina {
namespace {

/// Share of a uniform white sky that a surface without highlight sends to a viewer 45 degrees off its normal.
double furnace(const IlluminationModel& model, float kd) {
  constexpr uint32_t kPoints = 4096;
  const Vec3 n(0, 0, 1), wo = normalize(Vec3(1, 0, 1));
  const Surface surface{.kd = Rgb(kd), .base = Rgb(kd), .specular_weight = 0};
  double sum = 0;
  for (uint32_t i = 0; i < kPoints; ++i) {  // cosine-weighted: the estimator is f pi
    Vec3 wi = sample_cosine_hemisphere(sobol_owen(i, 1));
    wi.z = std::fmax(1e-6f, wi.z);
    sum += double(brdf(model, surface, n, wi, wo).total().g) * kPi;
  }
  return sum / kPoints;
}

// Those with a Lambertian part, and nothing else where there is no highlight.
constexpr std::string_view kModels[] = {"lambert",          "oren_nayar:sigma=0", "phong", "blinn_phong", "schlick",
                                        "torrance_sparrow", "cook_torrance",      "ward",  "ggx"};

}  // namespace

void add_furnace_cases(std::vector<ValidationCase>& cases) {
  for (const std::string_view model : kModels)
    cases.push_back({"furnace", std::string(model) + ": diffuse reflectance 0.7 under a uniform sky", "1", 0.7, 1e-5,
                     "the BRDF kd / pi integrates to kd",
                     [model] { return furnace(make_method(illumination_models(), "illumination", model), 0.7f); }});
}

}  // namespace aktina
