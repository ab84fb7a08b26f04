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
  double sum = 0;
  for (uint32_t i = 0; i < kPoints; ++i) {  // cosine-weighted: the estimator is f pi
    const Vec2 u = sobol_owen(i, 1);
    const float r = std::sqrt(u.x), phi = float(2 * kPi) * u.y, z = std::sqrt(std::fmax(1e-12f, 1 - u.x));
    sum +=
        double(brdf(model, Surface{.kd = Rgb(kd)}, n, {r * std::cos(phi), r * std::sin(phi), z}, wo).total().g) * kPi;
  }
  return sum / kPoints;
}

}  // namespace

void add_furnace_cases(std::vector<ValidationCase>& cases) {
  for (const auto* row : illumination_models())
    cases.push_back({"furnace", std::string(row->info.id) + ": diffuse reflectance 0.7 under a uniform sky", "1", 0.7,
                     1e-5, "the BRDF kd / pi integrates to kd",
                     [row] { return furnace(row->make(ParamSet(row->info)), 0.7f); }});
}

}  // namespace aktina
