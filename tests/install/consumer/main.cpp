// Light on a surface in a few lines, with an installed Aktina.
#include <aktina/base/version.h>
#include <aktina/illumination/light/light.h>
#include <aktina/illumination/model.h>
#include <aktina/render/catalogue.h>

#include <cstdio>

int main() {
  using namespace aktina;
  const PointLight lamp{.position = {0, 2, 0}, .intensity = Intensity(Rgb(100))};
  const LightSample light = sample(lamp, {0, 0, 0});
  const Reflectance f = brdf(Lambert{}, Surface{.kd = Rgb(0.5f)}, {0, 1, 0}, light.wi, {0, 1, 0});
  const Radiance seen(f.total() * light.e_perp.v);
  std::printf("aktina %.*s: %zu families; 100 cd at 2 m on a half grey surface: %.4f cd/m^2\n", int(version().size()),
              version().data(), families().size(), seen.v.g);
  return seen.v.g > 3.978f && seen.v.g < 3.980f ? 0 : 1;  // 0.5 / pi * 100 / 2^2
}
