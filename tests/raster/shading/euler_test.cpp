#include "aktina/raster/shading/euler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

constexpr float kDegree = float(kPi) / 180;

/// A normal that turns by an angle towards +x, and a lamp a share of the way along that stands still.
TurningPair turn(float degrees, float lamp_degrees = 0, float aside = 0) {
  const auto at = [](float angle) { return Vec3(std::sin(angle * kDegree), 0, std::cos(angle * kDegree)); };
  const Vec3 l = normalize(at(lamp_degrees) + Vec3(0, aside, 0));
  return {{at(0), at(degrees)}, {l, l}};
}

float exact(const TurningPair& v, float t) {
  return dot(normalize(linear(v.p[0], v.p[1], t)), normalize(linear(v.q[0], v.q[1], t)));
}

float value(const Quadratics& q, float t) {
  const float(&c)[3] = t >= q.split ? q.right : q.left;
  return c[0] + t * (c[1] + t * c[2]);
}

TEST(EulerShading, SlopesAreThoseOfTheNormalisedVectors) {
  TurningPair v = turn(50, 20, 0.3f);
  v.q[1] = normalize(Vec3(0.3f, 0.5f, 1));
  const EulerSlopes ends(v);
  const float h = 1e-2f;
  const auto f = [&](float t) { return exact(v, t); };
  EXPECT_NEAR(ends.slope[0], (-3 * f(0) + 4 * f(h) - f(2 * h)) / (2 * h), 2e-3f);
  EXPECT_NEAR(ends.slope[1], (3 * f(1) - 4 * f(1 - h) + f(1 - 2 * h)) / (2 * h), 2e-3f);
}

TEST(EulerShading, RecurrenceIsTheClosedForm) {
  for (const float degrees : {5.0f, 40.0f, 80.0f}) {
    const EulerSlopes ends(turn(degrees, 15, 0.2f));
    for (const int steps : {1, 2, 16, 200}) {
      const auto plain = euler_recurrence(ends, steps, false), corrected = euler_recurrence(ends, steps, true);
      for (int i = 0; i <= steps; ++i) {
        const float t = float(i) / float(steps);
        EXPECT_NEAR(plain[size_t(i)], value(plain_euler_curve(ends, float(steps)), t), 1e-5f);
        EXPECT_NEAR(corrected[size_t(i)], value(euler_curve(ends), t), 1e-5f);
      }
    }
  }
}

TEST(EulerShading, CorrectedIsExactAtBothEnds) {
  const EulerSlopes ends(turn(60, 10, 0.4f));
  const auto p = euler_recurrence(ends, 32, true);
  EXPECT_FLOAT_EQ(p.front(), ends.value[0]);
  EXPECT_NEAR(p.back(), ends.value[1], 1e-6f);
}

/// Largest errors over where the lamp stands, computed independently: Gouraud, plain, corrected.
TEST(EulerShading, ErrorsAreAsKnown) {
  const float degrees[] = {20, 40, 60}, gouraud[] = {0.0147f, 0.0585f, 0.130f}, plain[] = {0.0102f, 0.0776f, 0.243f},
              corrected[] = {0.0010f, 0.0083f, 0.030f};
  for (int k = 0; k < 3; ++k) {
    float worst[3] = {};
    for (float lamp = -90; lamp < 180; lamp += 2) {
      const TurningPair v = turn(degrees[k], lamp);
      const EulerSlopes ends(v);
      for (float t = 0; t <= 1; t += 1.0f / 64) {
        const float f = exact(v, t);
        worst[0] = std::max(worst[0], std::abs(f - linear(Vec3(ends.value[0]), Vec3(ends.value[1]), t).x));
        worst[1] = std::max(worst[1], std::abs(f - value(plain_euler_curve(ends, 64), t)));
        worst[2] = std::max(worst[2], std::abs(f - value(euler_curve(ends), t)));
      }
    }
    EXPECT_NEAR(worst[0], gouraud[k], 0.05f * gouraud[k]);
    EXPECT_NEAR(worst[1], plain[k], 0.1f * plain[k]);
    EXPECT_NEAR(worst[2], corrected[k], 0.1f * corrected[k]);
  }
}

TEST(EulerShading, DiffersFromGouraudByAnEighthOfTheBendAtMost) {
  const EulerSlopes ends(turn(50, 20));
  float worst = 0;
  for (float t = 0; t <= 1; t += 0.01f)
    worst =
        std::max(worst, std::abs(value(euler_curve(ends), t) - (ends.value[0] + t * (ends.value[1] - ends.value[0]))));
  EXPECT_NEAR(worst, std::abs(ends.bend()) / 8, 1e-5f);
}

TEST(EulerShading, PicturesAreTheRecurrence) {
  constexpr int kSteps = 40;
  const Vec3 n[2] = {normalize(Vec3(-0.3f, 0.1f, 1)), normalize(Vec3(0.5f, 0.2f, 1))},
             l = normalize(Vec3(0.2f, 0.3f, 1));
  const Light lamp = DirectionalLight{-l, Irradiance(Rgb(float(kPi)))};
  const Surface surface{.kd = Rgb(1)};
  const Illuminator light(Lambert{}, surface, std::span(&lamp, 1), Rgb(0), {{0, 0, 1}, true});
  ShadedTriangle triangle;  // the scanline from the middle of one edge to a corner, both at the middle of a pixel
  triangle.screen[0] = {0, 0}, triangle.screen[1] = {0, 2}, triangle.screen[2] = {float(kSteps), 1};
  triangle.normal[0] = triangle.normal[1] = n[0], triangle.normal[2] = n[1];
  std::vector<Vec3> points;
  for (int i = 0; i <= kSteps; ++i) {
    const float s = float(i) / kSteps;
    points.emplace_back((1 - s) / 2, (1 - s) / 2, s);
  }
  for (const bool corrected : {false, true}) {
    const std::string name = corrected ? "euler:threshold=0" : "euler:threshold=0,corrected=0";
    const auto lit = shade(*make_method(shading_methods(), "shading", name), light, triangle, points);
    const auto recurrence = euler_recurrence(EulerSlopes({{n[0], n[1]}, {l, l}}), kSteps, corrected);
    for (size_t i = 0; i <= kSteps; ++i) EXPECT_NEAR(lit[i].diffuse.g, recurrence[i], 1e-5f) << name << i;
  }
}

struct EulerPicture : testing::Test {
  const Surface surface{.kd = Rgb(0.7f), .ks = Rgb(0.5f), .exponent = 10};
  const Light lamp = DirectionalLight{normalize(Vec3(-0.3f, 0.2f, -1)), Irradiance(Rgb(3))};
  ShadedTriangle triangle;
  EulerPicture() {
    triangle.screen[0] = {0, 0}, triangle.screen[1] = {3, 19}, triangle.screen[2] = {20, 2};
    triangle.normal[1] = normalize(Vec3(0.3f, 0, 1)), triangle.normal[2] = normalize(Vec3(0, 0.35f, 1));
  }
  Lit at(Vec3 b, const char* method, const IlluminationModel& model = BlinnPhong{}) const {
    const Illuminator light(model, surface, std::span(&lamp, 1), Rgb(0.1f), {{0, 0, 1}, true});
    return shade(*make_method(shading_methods(), "shading", method), light, triangle, std::span(&b, 1))[0];
  }
};

TEST_F(EulerPicture, IsNearPhongAndNearerThanFence) {
  const Vec3 inside(0.4f, 0.25f, 0.35f);
  const float phong = at(inside, "phong").total().g;
  EXPECT_NEAR(at(inside, "euler").total().g, phong, 0.02f * phong);
  EXPECT_LT(std::abs(at(inside, "euler").total().g - phong), std::abs(at(inside, "fence").total().g - phong) / 3);
}

TEST_F(EulerPicture, IsGouraudAlongTheSpanBelowItsThreshold) {
  const Vec3 inside(0.4f, 0.25f, 0.35f);
  EXPECT_NEAR(at(inside, "euler:threshold=1", Lambert{}).total().g, at(inside, "fence", Lambert{}).total().g, 1e-5f);
  EXPECT_GT(std::abs(at(inside, "euler", Lambert{}).total().g - at(inside, "fence", Lambert{}).total().g), 1e-4f);
}

}  // namespace
}  // namespace aktina
