// Spherical interpolation, and angular interpolation: exact, angular_decomposed, angular_combined, angular_power.
#include "aktina/raster/shading/angular.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

constexpr float kDegree = float(kPi) / 180;

Vec3 any_direction(Pcg32& random) {
  const float z = 2 * random.uniform() - 1, phi = 2 * float(kPi) * random.uniform(), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A direction that another makes an angle with.
Vec3 beside(Vec3 n, float angle, Pcg32& random) {
  const Frame frame(n);
  const float phi = 2 * float(kPi) * random.uniform();
  return frame.to_world({std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), std::cos(angle)});
}

TurningPair turning(float p_degrees, float q_degrees, Pcg32& random) {
  TurningPair v;
  v.p[0] = any_direction(random), v.p[1] = beside(v.p[0], p_degrees * kDegree, random);
  v.q[0] = beside(v.p[0], 60 * kDegree * random.uniform(), random);
  v.q[1] = beside(v.q[0], q_degrees * kDegree, random);
  return v;
}

float value(const Waves& w, float t) {
  float sum = 0;
  for (int k = 0; k < 2; ++k) sum += w.cosine[k] * std::cos(w.turn[k] * t) + w.sine[k] * std::sin(w.turn[k] * t);
  return sum;
}

float gouraud(const TurningPair& v, float t) { return (1 - t) * dot(v.p[0], v.q[0]) + t * dot(v.p[1], v.q[1]); }

TEST(Slerp, TurnsUniformlyOnAGreatCircle) {
  Pcg32 random(1);
  for (int round = 0; round < 50; ++round) {
    const Vec3 a = any_direction(random), b = any_direction(random);
    const float angle = std::acos(dot(a, b));
    for (const float t : {0.0f, 0.3f, 0.5f, 1.0f}) {
      const Vec3 n = slerp(a, b, t);
      EXPECT_NEAR(length(n), 1, 1e-6f);
      EXPECT_NEAR(std::acos(std::min(dot(a, n), 1.0f)), t * angle, 1e-3f);
      EXPECT_NEAR(dot(n, normalize(cross(a, b))), 0, 1e-5f);
    }
    EXPECT_NEAR(length(slerp(a, b, 1) - b), 0, 1e-5f);
  }
  EXPECT_NEAR(length(slerp({0, 0, 1}, {0, 0, 1}, 0.5f) - Vec3(0, 0, 1)), 0, 1e-6f);
  EXPECT_NEAR(length(slerp({0, 0, 1}, {0, 0, -1}, 0.5f)), 1, 1e-6f);
}

TEST(ArcRecurrence, StaysOfUnitLengthAndIsTheClosedForm) {
  Pcg32 random(2);
  const Arc arc(any_direction(random), any_direction(random));
  constexpr int kSteps = 64;
  const auto recurrence = arc_recurrence(arc, kSteps);
  alignas(64) float n[3][80];
  fill_arc(arc, 0, 1.0f / kSteps, kSteps + 1, {n[0], n[1], n[2]});
  for (size_t i = 0; i <= kSteps; ++i) {
    EXPECT_NEAR(length(recurrence[i]), 1, 2e-7f);
    EXPECT_NEAR(length(recurrence[i] - Vec3(n[0][i], n[1][i], n[2][i])), 0, 2e-6f);
  }
}

TEST(AngularShading, ExactFormulaIsTheCosineOfTwoSlerps) {
  Pcg32 random(3);
  for (int round = 0; round < 100; ++round) {
    const TurningPair v = turning(100 * random.uniform(), 60 * random.uniform(), random);
    for (const float t : {0.0f, 0.25f, 0.5f, 0.8f, 1.0f})
      EXPECT_NEAR(value(turning_cosine(v), t), dot(slerp(v.p[0], v.p[1], t), slerp(v.q[0], v.q[1], t)), 1e-6f);
  }
}

TEST(AngularShading, CosineRecurrenceIsTheClosedForm) {
  Pcg32 random(4);
  for (const int steps : {1, 7, 500}) {
    const Waves w = turning_cosine(turning(70, 30, random));
    const auto recurrence = cosine_recurrence(w, steps);
    for (int i = 0; i <= steps; ++i)
      EXPECT_NEAR(recurrence[size_t(i)], value(w, float(i) / float(steps)), 2e-6f) << steps;
  }
}

TEST(AngularDecomposed, IsExactAtTheEndsAndForALampThatStandsStill) {
  Pcg32 random(5);
  for (int round = 0; round < 100; ++round) {
    TurningPair v = turning(50, 25, random);
    EXPECT_NEAR(value(decomposed_cosine(v), 0), dot(v.p[0], v.q[0]), 1e-5f);
    EXPECT_NEAR(value(decomposed_cosine(v), 1), dot(v.p[1], v.q[1]), 1e-5f);
    v.q[1] = v.q[0];
    EXPECT_NEAR(value(decomposed_cosine(v), 0.4f), value(turning_cosine(v), 0.4f), 1e-5f);
  }
}

TEST(AngularCombined, IsExactAtTheEndsAndForALampThatStandsStill) {
  Pcg32 random(6);
  for (int round = 0; round < 100; ++round) {
    TurningPair v = turning(50, 25, random);
    EXPECT_NEAR(value(CombinedPair(v).cosine(), 0), dot(v.p[0], v.q[0]), 1e-5f);
    EXPECT_NEAR(value(CombinedPair(v).cosine(), 1), dot(v.p[1], v.q[1]), 1e-5f);
    v.q[1] = v.q[0];
    EXPECT_NEAR(value(CombinedPair(v).cosine(), 0.4f), value(turning_cosine(v), 0.4f), 1e-5f);
  }
}

TEST(AngularShading, ApproximationsAreBetterThanGouraud) {
  for (const auto& [p, q, decomposed, combined] :
       {std::array{20.0f, 10.0f, 0.02f, 0.02f}, {40.0f, 20.0f, 0.08f, 0.08f}}) {
    Pcg32 random(7);
    float sum[3] = {};
    for (int round = 0; round < 400; ++round) {
      const TurningPair v = turning(p, q, random);
      const float exact = value(turning_cosine(v), 0.5f);
      sum[0] += std::abs(gouraud(v, 0.5f) - exact);
      sum[1] += std::abs(value(decomposed_cosine(v), 0.5f) - exact);
      sum[2] += std::abs(value(CombinedPair(v).cosine(), 0.5f) - exact);
      EXPECT_LT(std::abs(value(CombinedPair(v).cosine(), 0.5f) - exact), combined);
    }
    EXPECT_LT(sum[1], sum[0] / 3);
    EXPECT_LT(sum[2], sum[0] / 2);
  }
}

TEST(KuijkPower, IsOnceDifferentiableAndAsFarOffAsKnown) {
  const float exponents[] = {2, 5, 10, 20, 50, 100, 200},
              largest[] = {0.041f, 0.014f, 0.020f, 0.015f, 0.018f, 0.036f, 0.111f};
  for (int k = 0; k < 7; ++k) {
    float worst = 0, slope = 0, before = 1;
    for (float a = 0; a < 1.57f; a += 1e-3f) {
      const float f = kuijk_power(a, exponents[k]);
      worst = std::max(worst, std::abs(f - std::pow(std::cos(a), exponents[k])));
      EXPECT_LT(std::abs((f - before) - slope), 2e-6f * exponents[k] * 2) << a;  // no kink
      slope = f - before, before = f;
    }
    EXPECT_NEAR(worst, largest[k], 0.0006f) << exponents[k];
  }
}

TEST(AngularPower, ALampInTheNormalsPlaneGivesTheParabolasOfALinearAngle) {
  const auto at = [](float degrees) { return Vec3(std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree)); };
  const PowerOfAngle p = power_of_angle(CombinedPair({{at(0), at(50)}, {at(20), at(20)}}), 20);
  EXPECT_NEAR(p.scale, 1, 1e-5f);
  for (const float t : {0.0f, 0.4f, 1.0f}) EXPECT_NEAR(p.from + p.turn * t, (50 * t - 20) * kDegree, 1e-5f);
}

/// What methods draw along a scanline from edge to edge, pixel by pixel: lamp and viewer far away, white light.
struct AngularSpan : testing::Test {
  static constexpr int kSteps = 40;
  const Vec3 n[2] = {normalize(Vec3(-0.3f, 0.1f, 1)), normalize(Vec3(0.5f, 0.2f, 1))},
             l = normalize(Vec3(0.2f, 0.3f, 1));
  const Light lamp = DirectionalLight{-l, Irradiance(Rgb(float(kPi)))};
  const Viewer viewer{{0, 0, 1}, true};
  const Vec3 h = normalize(l + viewer.at);

  /// Steps from the middle of one edge to that of another, whose ends have the same normals.
  std::vector<Lit> draw(const char* method, float exponent) const {
    const Surface surface{.kd = Rgb(1), .ks = Rgb(1), .exponent = exponent};
    const Illuminator light(BlinnPhong{}, surface, std::span(&lamp, 1), Rgb(0), viewer);
    ShadedTriangle t;
    t.screen[0] = {0, 0}, t.screen[1] = {0, 2}, t.screen[2] = {float(kSteps), 1};
    t.normal[0] = t.normal[1] = n[0], t.normal[2] = n[1];
    std::vector<Vec3> points;
    for (int i = 0; i <= kSteps; ++i) {
      const float s = float(i) / kSteps;
      points.emplace_back((1 - s) / 2, (1 - s) / 2, s);
    }
    return shade(*make_method(shading_methods(), "shading", method), light, t, points);
  }
};

TEST_F(AngularSpan, DiffuseLightIsTheRecurrenceOfTheCosine) {
  const TurningPair pair{{n[0], n[1]}, {l, l}};
  for (const auto& [method, waves] : {std::pair{"angular", turning_cosine(pair)},
                                      {"angular_decomposed", decomposed_cosine(pair)},
                                      {"angular_combined", CombinedPair(pair).cosine()}}) {
    const auto lit = draw(method, 20);
    const auto cosine = cosine_recurrence(waves, kSteps);
    for (size_t i = 0; i <= kSteps; ++i) EXPECT_NEAR(lit[i].diffuse.g, cosine[i], 1e-5f) << method << i;
  }
}

TEST_F(AngularSpan, HighlightIsTheRecurrenceOfItsParabolas) {
  for (const float exponent : {2.0f, 20.0f, 150.0f}) {
    const auto lit = draw("angular_power", exponent);
    const auto power = power_recurrence(power_of_angle(CombinedPair({{n[0], n[1]}, {h, h}}), exponent), kSteps);
    for (size_t i = 0; i <= kSteps; ++i) EXPECT_NEAR(lit[i].specular.g, power[i], 3e-5f) << exponent << ' ' << i;
  }
}

TEST_F(AngularSpan, SphericalNormalsAreTheRecurrenceOfTheArc) {
  const auto lit = draw("spherical", 20);
  const auto normals = arc_recurrence(Arc(n[0], n[1]), kSteps);
  for (size_t i = 0; i <= kSteps; ++i) {
    EXPECT_NEAR(lit[i].diffuse.g, dot(normals[i], l), 1e-5f);
    EXPECT_NEAR(lit[i].specular.g, std::pow(dot(normals[i], h), 20.0f), 1e-4f);
  }
}

struct AngularPicture : testing::Test {
  Surface surface{.kd = Rgb(0.7f), .ks = Rgb(0.5f), .exponent = 20};
  std::vector<Light> lamps{DirectionalLight{normalize(Vec3(-0.3f, 0.2f, -1)), Irradiance({3, 2, 1})},
                           PointLight{{1, 1, 3}, Intensity({2, 4, 6}), {}}};
  ShadedTriangle triangle;
  AngularPicture() {
    triangle.screen[0] = {0, 0}, triangle.screen[1] = {3, 19}, triangle.screen[2] = {20, 2};
    triangle.normal[1] = normalize(Vec3(0.4f, 0, 1)), triangle.normal[2] = normalize(Vec3(0, 0.45f, 1));
    triangle.weight[1] = 0.8f;
  }
  Rgb at(Vec3 b, const char* method, const IlluminationModel& model = BlinnPhong{}) const {
    const Illuminator light(model, surface, lamps, Rgb(0.1f), {{0, 0, 4}, false});
    return shade(*make_method(shading_methods(), "shading", method), light, triangle, std::span(&b, 1))[0].total();
  }
};

TEST_F(AngularPicture, AllAreNearPhongForTheirModels) {
  for (const IlluminationModel& model : {IlluminationModel(Lambert{}), {Phong{}}, {BlinnPhong{}}, {Schlick{}}})
    for (const Vec3 b : {Vec3(0.4f, 0.25f, 0.35f), Vec3(0.2f, 0.6f, 0.2f)})
      for (const char* method : {"spherical", "angular", "angular_decomposed", "angular_combined", "angular_power"}) {
        if (std::string(method) == "angular_power" && std::holds_alternative<Schlick>(model)) continue;
        const Rgb phong = at(b, "phong", model), other = at(b, method, model);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(other[k], phong[k], 0.05f * phong[k]) << method;
      }
}

TEST_F(AngularPicture, ModelsThatAreNoFunctionOfTheCosinesAreRefused) {
  const Vec3 b(0.4f, 0.25f, 0.35f);
  for (const char* method :
       {"angular", "angular_decomposed", "angular_combined", "angular_power", "euler", "fast_phong", "lin"})
    EXPECT_THROW(at(b, method, OrenNayar{}), Error) << method;
  EXPECT_THROW(at(b, "angular", Phong{.fresnel = true}), Error);
  EXPECT_THROW(at(b, "angular_power", Schlick{}), Error);
  EXPECT_GT(at(b, "spherical", OrenNayar{}).g, 0);
}

TEST_F(AngularPicture, EveryModelGoesWithSphericalNormals) {
  const Vec3 b(0.4f, 0.25f, 0.35f);
  for (const auto* row : illumination_models()) {
    const IlluminationModel model = row->make(ParamSet(row->info));
    EXPECT_NEAR(at(b, "spherical", model).g, at(b, "phong", model).g, 0.03f * at(b, "phong", model).g) << row->info.id;
  }
}

}  // namespace
}  // namespace aktina
