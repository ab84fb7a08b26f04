#include <gtest/gtest.h>

#include <cmath>

#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

/// Light of the three corners and of a point, by Gouraud's interpolation.
struct GouraudTest : testing::Test {
  const Surface surface{.kd = Rgb(1), .ks = Rgb(0.5f), .exponent = 40};
  const Light lamp = DirectionalLight{{0, 0, -1}, Irradiance(Rgb(float(kPi)))};
  const Illuminator light{BlinnPhong{}, surface, std::span(&lamp, 1), Rgb(0.1f), {{0, 0, 1}, true}};
  ShadedTriangle triangle;
  float at(Vec3 b, const char* method) const {
    return shade(*make_method(shading_methods(), "shading", method), light, triangle, std::span(&b, 1))[0].total().g;
  }
};

TEST_F(GouraudTest, IsLinearOnTheScreenAsPublished) {
  triangle.normal[1] = normalize(Vec3(1, 0, 1)), triangle.weight[1] = 0.25f;
  const float a = at({1, 0, 0}, "gouraud"), b = at({0, 1, 0}, "gouraud");
  for (const float t : {0.2f, 0.5f, 0.9f}) EXPECT_NEAR(at({1 - t, t, 0}, "gouraud"), (1 - t) * a + t * b, 1e-5f);
}

TEST_F(GouraudTest, IsLinearOnTheSurfaceWhereAskedTo) {
  triangle.normal[1] = normalize(Vec3(1, 0, 1)), triangle.weight[1] = 0.25f;
  const float a = at({1, 0, 0}, "gouraud"), b = at({0, 1, 0}, "gouraud");
  const float t = 0.5f * 0.25f / (0.5f + 0.5f * 0.25f);  // the middle of the screen is nearer to the near corner
  EXPECT_NEAR(at({0.5f, 0.5f, 0}, "gouraud:perspective=1"), (1 - t) * a + t * b, 1e-5f);
}

TEST_F(GouraudTest, LosesAHighlightInsideTheTriangle) {
  for (int v = 0; v < 3; ++v)  // corners lean away from the lamp on three sides
    triangle.normal[v] = normalize(Vec3(std::cos(2.1f * float(v)), std::sin(2.1f * float(v)), 1));
  const Vec3 centre(1.0f / 3);
  EXPECT_LT(at(centre, "gouraud") + 0.4f, at(centre, "phong"));
}

}  // namespace
}  // namespace aktina
