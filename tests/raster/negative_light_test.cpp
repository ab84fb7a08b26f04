#include <gtest/gtest.h>

#include <algorithm>

#include "aktina/raster/rasterize.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

/// A coarse sphere with a highlight much smaller than its triangles: polynomials swing below zero around it.
Scene sharp_highlight() {
  Scene scene;
  const int shiny = test::add_material(scene, {.kd = Rgb(0.05f), .ks = Rgb(1), .exponent = 200});
  test::add_mesh(scene, test::bumpy_sphere(12, 9, 0), shiny);
  scene.lights.push_back({"lamp", PointLight{{1, 1, 4}, Intensity(Rgb(30)), {}}, -1});
  scene.cameras.push_back(look_at({0, 0, 3.2f}, {0, 0, 0}, {0, 1, 0}, 0.7346f));
  return scene;
}

TEST(NegativeLight, PolynomialsThatSwingBelowZeroAreBlackThere) {
  const Scene scene = sharp_highlight();
  for (const char* shading : {"quadratic", "cubic", "seiler"})
    for (const bool albedo : {false, true}) {  // colour at once, or from visible pixels
      const LayeredImage out = rasterize(scene, scene.cameras[0], 256, 256, {.shading = shading, .albedo = albedo});
      const auto& pixels = out.layers[0].image.pixels;
      EXPECT_GE(*std::min_element(pixels.begin(), pixels.end()), 0) << shading << albedo;
      EXPECT_GT(*std::max_element(pixels.begin(), pixels.end()), 0) << shading << albedo;
    }
}

}  // namespace
}  // namespace aktina
