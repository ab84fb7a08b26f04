// Photometric one-liners: what a lamp of known flux gives at a known place.
#include <cmath>

#include "aktina/illumination/light/light.h"
#include "aktina/render/validate_cases.h"
#include "aktina/trace/illuminance.h"

namespace aktina {
namespace {

PointLight isotropic(double lumens) { return {.intensity = Intensity(Rgb(float(lumens / (4 * kPi))))}; }

constexpr double kDisc = 0.01;  // m

/// A disc that shines 100 lm downwards, and what a light meter reads below it.
double disc_on_axis(float distance) {
  Scene scene;
  Material lamp;
  lamp.base_colour = Rgb(0);
  lamp.emission = Radiance(Rgb(float(100 / (kPi * kPi * kDisc * kDisc))));  // L = flux / (pi A)
  scene.materials.push_back(lamp);
  scene.primitives.emplace_back(Disc{float(kDisc)});
  Instance instance;
  instance.primitive = 0, instance.material = 0;
  instance.to_world[1] = {0, -1, 0, 0}, instance.to_world[2] = {0, 0, -1, 0};  // turned about x: it faces down
  scene.instances.push_back(instance);
  TraceOptions options;
  options.integrator = "direct", options.samples = 256;
  const Point3 meter(0, -distance, 0);
  const Vec3 up(0, 1, 0);
  return illuminance(scene, std::span(&meter, 1), std::span(&up, 1), options)[0].v.g;
}

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
  cases.push_back({"photometry", "100 lm Lambertian disc of 10 mm, on axis at 1 m", "lx",
                   100 / kPi / (1 + kDisc * kDisc), 0.02, "E = flux / (pi (d^2 + r^2))",
                   [] { return disc_on_axis(1); }});
  cases.push_back({"photometry", "100 lm Lambertian disc of 10 mm, on axis at 2 m", "lx",
                   100 / kPi / (4 + kDisc * kDisc), 0.005, "E = flux / (pi (d^2 + r^2))",
                   [] { return disc_on_axis(2); }});
  cases.push_back(
      {"photometry", "flux of a 100 cd spot with a hard cone of 30 degrees", "lm", 200 * kPi * (1 - std::cos(kPi / 6)),
       1e-3, "intensity times solid angle of the cone", [] {
         const auto angle = float(kPi / 6);
         return flux(SpotLight{.intensity = Intensity(Rgb(100)), .inner_angle = angle, .outer_angle = angle})->v.g;
       }});
}

}  // namespace aktina
