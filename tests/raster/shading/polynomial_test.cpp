// Methods whose colour or normal is a polynomial on the triangle: quadratic, cubic, seiler, quadratic_normals,
// overveld_wyvill, lee_jen, hybrid.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

struct PolynomialShading : testing::Test {
  Surface surface{.kd = Rgb(0.7f), .ks = Rgb(0.4f), .exponent = 20};
  Light lamp = DirectionalLight{normalize(Vec3(-0.2f, -0.3f, -1)), Irradiance(Rgb(float(kPi)))};
  ShadedTriangle triangle;

  PolynomialShading() {
    triangle.normal[1] = normalize(Vec3(0.5f, 0.1f, 1)), triangle.normal[2] = normalize(Vec3(-0.1f, 0.6f, 1));
  }
  Illuminator light() const { return {BlinnPhong{}, surface, std::span(&lamp, 1), Rgb(0.1f), {{0, 0, 1}, true}}; }
  Lit at(Vec3 b, const char* method) const {
    return shade(*make_method(shading_methods(), "shading", method), light(), triangle, std::span(&b, 1))[0];
  }
  /// The normal that a method has at a point: what a surface with kd = 1 shows under lamps along the axes.
  Vec3 normal_at(Vec3 b, const char* method) const {
    Vec3 n;
    for (int k = 0; k < 3; ++k) {
      float value[2];
      for (const int side : {0, 1}) {
        Vec3 direction(0);
        direction[k] = side ? 1.0f : -1.0f;  // the way the light travels
        const Light axis = DirectionalLight{direction, Irradiance(Rgb(float(kPi)))};
        const Illuminator one(Lambert{}, Surface{.kd = Rgb(1)}, std::span(&axis, 1), Rgb(0), {{0, 0, 1}, true});
        value[side] =
            shade(*make_method(shading_methods(), "shading", method), one, triangle, std::span(&b, 1))[0].diffuse.g;
      }
      n[k] = value[0] - value[1];
    }
    return n;
  }
};

const Vec3 kMiddles[] = {{0.5f, 0.5f, 0}, {0, 0.5f, 0.5f}, {0.5f, 0, 0.5f}};

TEST_F(PolynomialShading, QuadraticIsPhongAtItsSixSamples) {
  for (const Vec3 b : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), kMiddles[0], kMiddles[1], kMiddles[2]})
    EXPECT_NEAR(at(b, "quadratic").total().g, at(b, "phong").total().g, 1e-4f);
}

TEST_F(PolynomialShading, CubicIsPhongAtItsTenSamples) {
  for (const auto& b : lattice(3))
    EXPECT_NEAR(at({b[0], b[1], b[2]}, "cubic").total().g, at({b[0], b[1], b[2]}, "phong").total().g, 1e-4f);
}

TEST_F(PolynomialShading, SeilerIsQuadraticAndGouraudWhereNoEdgeExceedsItsThreshold) {
  Pcg32 random(4);
  for (int i = 0; i < 20; ++i) {
    const float r = std::sqrt(random.uniform()), s = random.uniform();
    const Vec3 b(1 - r, r * (1 - s), r * s);
    EXPECT_NEAR(at(b, "seiler").total().g, at(b, "quadratic").total().g, 1e-5f);
    EXPECT_NEAR(at(b, "seiler:threshold=1000").total().g, at(b, "gouraud").total().g, 1e-5f);
  }
}

TEST_F(PolynomialShading, HigherDegreesComeNearerToPhong) {
  surface.ks = Rgb(0);
  double error[3] = {};
  const char* methods[] = {"gouraud", "quadratic", "cubic"};
  Pcg32 random(9);
  for (int i = 0; i < 200; ++i) {
    const float r = std::sqrt(random.uniform()), s = random.uniform();
    const Vec3 b(1 - r, r * (1 - s), r * s);
    for (int k = 0; k < 3; ++k) error[k] += std::abs(double(at(b, methods[k]).total().g - at(b, "phong").total().g));
  }
  EXPECT_LT(error[1], error[0] / 4);
  EXPECT_LT(error[2], error[1]);  // and hardly more, as the literature has it
}

TEST_F(PolynomialShading, QuadraticNormalsKeepTheirLengthAsKnown) {
  // Largest | |N| - 1 | along an edge that turns by an angle: computed independently.
  const float degrees[] = {20, 40, 60, 90}, largest[] = {3.0e-5f, 4.6e-4f, 2.3e-3f, 1.1e-2f};
  for (int k = 0; k < 4; ++k) {
    const float half = degrees[k] / 2 * float(kPi) / 180;
    triangle.normal[0] = {-std::sin(half), 0, std::cos(half)}, triangle.normal[1] = {std::sin(half), 0, std::cos(half)};
    float worst = 0;
    for (float t = 0; t <= 1; t += 0.02f)
      worst = std::max(worst, std::abs(length(normal_at({1 - t, t, 0}, "quadratic_normals")) - 1));
    EXPECT_NEAR(worst, largest[k], 0.06f * largest[k] + 2e-6f) << degrees[k];
  }
}

TEST_F(PolynomialShading, QuadraticNormalsFollowAnInflectedEdge) {
  // Equal normals at both ends of a rising edge: the surface is an S, steeper in the middle; Phong sees a plane.
  triangle.position[1] = {1, 0, 0.4f};
  triangle.normal[0] = triangle.normal[1] = {0, 0, 1};
  EXPECT_NEAR(normal_at(kMiddles[0], "phong").x, 0, 1e-5f);
  const Vec3 edge = normalize(triangle.position[1] - triangle.position[0]);
  for (const char* method : {"overveld_wyvill", "lee_jen"})
    EXPECT_LT(dot(normal_at(kMiddles[0], method), edge), -0.01f) << method;  // leans back, as the steep middle does
}

TEST_F(PolynomialShading, LeeJenOnAFlatEdgeWithEqualNormalsIsTheBisector) {
  triangle.normal[0] = triangle.normal[1] = normalize(Vec3(0, 0.3f, 1));
  const Vec3 n = normal_at(kMiddles[0], "lee_jen");
  EXPECT_NEAR(length(n - triangle.normal[0]), 0, 1e-5f);
}

TEST_F(PolynomialShading, HybridIsGouraudWithoutHighlightsAndPhongWithThemAlone) {
  for (const Vec3 b : {Vec3(0.2f, 0.3f, 0.5f), kMiddles[1]}) {
    surface.ks = Rgb(0), surface.kd = Rgb(0.7f);
    EXPECT_NEAR(at(b, "hybrid").total().g, at(b, "gouraud").total().g, 1e-5f);
    surface.ks = Rgb(0.4f), surface.kd = Rgb(0);
    EXPECT_NEAR(at(b, "hybrid").total().g, at(b, "phong").total().g, 1e-4f);
  }
}

}  // namespace
}  // namespace aktina
