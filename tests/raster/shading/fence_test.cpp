#include <gtest/gtest.h>

#include <cmath>

#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

struct FenceShading : testing::Test {
  const Surface surface{.kd = Rgb(0.7f), .ks = Rgb(0.5f), .exponent = 30};
  const std::vector<Light> lamps{PointLight{{0.3f, 0.2f, 2}, Intensity({5, 6, 7})},
                                 DirectionalLight{normalize(Vec3(-1, -1, -1)), Irradiance(Rgb(2))}};
  const Illuminator light{Phong{}, surface, lamps, Rgb(0.1f), {{0, 0, 3}, false}};
  ShadedTriangle triangle;

  FenceShading() {
    triangle.screen[0] = {0, 0}, triangle.screen[1] = {3, 9}, triangle.screen[2] = {10, 2};
    triangle.normal[1] = normalize(Vec3(0.6f, 0, 1)), triangle.normal[2] = normalize(Vec3(0, 0.7f, 1));
    triangle.weight[1] = 0.5f;
  }
  Rgb at(Vec3 b, const char* method) const {
    return shade(*make_method(shading_methods(), "shading", method), light, triangle, std::span(&b, 1))[0].total();
  }
};

TEST_F(FenceShading, IsPhongOnTheEdges) {
  for (const float t : {0.0f, 0.2f, 0.5f, 0.9f})
    for (const Vec3 b : {Vec3(1 - t, t, 0), Vec3(0, 1 - t, t), Vec3(t, 0, 1 - t)})
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(at(b, "fence")[k], at(b, "phong")[k], 2e-4f * (1 + at(b, "phong")[k]));
}

TEST_F(FenceShading, IsLinearBetweenTheEndsOfASpan) {
  // Along y = 1: from (1/3, 1) on edge 01 to (5, 1) on edge 20.
  const Vec3 left(8.0f / 9, 1.0f / 9, 0), right(0.5f, 0, 0.5f);
  for (const float t : {0.25f, 0.5f, 0.8f}) {
    const Rgb between = at(left, "fence") * (1 - t) + at(right, "fence") * t;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(at(left * (1 - t) + right * t, "fence")[k], between[k], 2e-4f);
  }
}

TEST_F(FenceShading, DependsOnHowTheTriangleIsTurned) {
  const Vec3 inside(0.4f, 0.25f, 0.35f);
  const float before = at(inside, "fence").g;
  for (Vec2& s : triangle.screen) s = {s.y, s.x};
  EXPECT_GT(std::abs(at(inside, "fence").g - before), 1e-3f);
}

}  // namespace
}  // namespace aktina
