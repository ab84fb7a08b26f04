#include "aktina/raster/rasterize.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

using test::add_matt;
using test::add_mesh;
using test::quad;

/// A matt square at z = 0 before a camera at z = 2 that sees a little more than it, a lamp of 10 cd above its middle.
Scene lit_square() {
  Scene scene;
  add_mesh(scene, quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}), add_matt(scene, {0.2f, 0.4f, 0.8f}));
  scene.lights.push_back({"lamp", PointLight{{0, 0, 1}, Intensity(Rgb(10)), {}}, -1});
  scene.cameras.push_back(look_at({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 1.2f));
  return scene;
}

TEST(Rasterize, PhongShadingOfAMattPlaneIsTheCosineLaw) {
  const Scene scene = lit_square();
  constexpr int kSize = 65;
  const LayeredImage picture = rasterize(scene, scene.cameras[0], kSize, kSize, {.position = true, .depth = true});
  const Image& p = *picture.find("P");
  int seen = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      if (!std::isfinite(picture.find("Z")->at(x, y)[0])) continue;
      ++seen;
      const float px = p.at(x, y)[0], py = p.at(x, y)[1], d2 = px * px + py * py + 1;
      EXPECT_NEAR(p.at(x, y)[2], 0, 1e-5);
      EXPECT_NEAR(picture.find("Z")->at(x, y)[0], 2, 1e-5);
      const float e = 10 / (d2 * std::sqrt(d2));  // I cos / d^2
      EXPECT_NEAR(picture.layers[0].image.rgb(x, y).g, 0.4 * e / kPi, 1e-5 * e);
    }
  const double side = kSize / (2 * 2 * std::tan(0.6)) * 2;  // pixels that the square covers
  EXPECT_NEAR(seen, side * side, 2 * side);
}

TEST(Rasterize, WrongOptionsAreRefused) {
  const Scene scene = lit_square();
  const auto render = [&](int width, int height, const RasterOptions& options) {
    return rasterize(scene, scene.cameras[0], width, height, options);
  };
  EXPECT_THROW(render(8, 8, {.samples = 3}), Error);
  EXPECT_THROW(render(0, 8, {}), Error);
  EXPECT_THROW(render(60000, 60000, {}), Error);
  EXPECT_THROW(render(8, 8, {.shading = "no_such_method"}), Error);
  EXPECT_THROW(render(8, 8, {.shading = "gouraud:perspective=0.5"}), Error);
}

TEST(RasterizeItems, NamesTheTriangleThatIsSeen) {
  Scene scene = lit_square();
  add_mesh(scene, quad({-0.5f, -0.5f, 0.1f}, {0.5f, -0.5f, 0.1f}, {0.5f, 0.5f, 0.1f}, {-0.5f, 0.5f, 0.1f}), 0);
  const ItemBuffer items = rasterize_items(scene, scene.cameras[0], 64, 64);
  EXPECT_EQ(items.item[0], ItemBuffer::kNothing);
  EXPECT_EQ(items.item[40 * 64 + 36], 2U);  // lower right half of the square in front
  EXPECT_EQ(items.item[24 * 64 + 28], 3U);
  EXPECT_EQ(items.item[54 * 64 + 32], 0U);
}

}  // namespace
}  // namespace aktina
