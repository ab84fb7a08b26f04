// Photometric one-liners: what a lamp of known flux gives at a known place.
#include <cmath>

#include "aktina/illumination/light/light.h"
#include "aktina/render/validate_cases.h"

namespace aktina {
namespace {

PointLight isotropic(double lumens) { return {.intensity = Intensity(Rgb(float(lumens / (4 * kPi))))}; }

}  // namespace

void add_photometry_cases(std::vector<ValidationCase>& cases) {
  cases.push_back({"photometry", "isotropic 100 lm point, facing it at 1 m", "lx", 100 / (4 * kPi), 1e-5,
                   "E = flux / (4 pi d^2)", [] {
                     return sample(isotropic(100), {0, 0, 1}).e_perp.v.g;
                   }});
  cases.push_back({"photometry", "isotropic 100 lm point, facing it at 2 m", "lx", 100 / (16 * kPi), 1e-5,
                   "inverse square law", [] {
                     return sample(isotropic(100), {0, 2, 0}).e_perp.v.g;
                   }});
  cases.push_back(
      {"photometry", "flux of a 100 cd spot with a hard cone of 30 degrees", "lm", 200 * kPi * (1 - std::cos(kPi / 6)),
       1e-3, "intensity times solid angle of the cone", [] {
         const auto angle = float(kPi / 6);
         return flux(SpotLight{.intensity = Intensity(Rgb(100)), .inner_angle = angle, .outer_angle = angle})->v.g;
       }});
}

}  // namespace aktina
