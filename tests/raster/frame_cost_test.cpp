// What a rasterizer says about the cost of a frame.
#include <gtest/gtest.h>

#include "aktina/base/parallel.h"
#include "aktina/raster/rasterize.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

struct Drawn {
  FrameCost cost;
  uint64_t seen = 0;  // pixels
};

Drawn draw(const std::string& shading) {
  Scene scene;
  test::add_mesh(scene, test::bumpy_sphere(36, 20), test::add_matt(scene, Rgb(0.5f)));
  scene.lights.push_back({"lamp", PointLight{{0, 0, 4}, Intensity(Rgb(40)), {}}, -1});
  scene.cameras.push_back(look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.8f));
  set_thread_count(1);
  Rasterizer rasterizer(scene, {.shading = shading, .depth = true});
  LayeredImage out;
  rasterizer.draw(scene.cameras[0], 128, 128, out);
  set_thread_count(0);
  Drawn drawn{rasterizer.last_frame()};
  for (const float z : out.find("Z")->pixels) drawn.seen += std::isfinite(z);
  return drawn;
}

TEST(FrameCost, GouraudLightsVerticesAndNoPixels) {
  const Drawn gouraud = draw("gouraud");
  EXPECT_GE(gouraud.cost.setup_evaluations, 37u * 21) << "each vertex";
  EXPECT_EQ(gouraud.cost.pixel_evaluations, 0u);
}

TEST(FrameCost, PhongLightsEachVisiblePixelAndNoVertices) {
  const Drawn phong = draw("phong");
  EXPECT_EQ(phong.cost.setup_evaluations, 0u);
  EXPECT_GE(phong.cost.pixel_evaluations, phong.seen);
  EXPECT_LE(phong.cost.pixel_evaluations, 2 * phong.seen) << "no more lanes empty than filled";
}

TEST(FrameCost, CountsTrianglesAndTime) {
  const FrameCost cost = draw("quadratic").cost;
  EXPECT_GT(cost.triangles, 500u);
  EXPECT_LE(cost.triangles, 2u * 36 * 20);
  EXPECT_GE(cost.setup_evaluations, 37u * 21 + 3 * (cost.triangles - 40)) << "corners, and three middles a triangle";
  EXPECT_GT(cost.setup_seconds, 0);
  EXPECT_GT(cost.pixel_seconds, 0);
}

}  // namespace
}  // namespace aktina
