#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "illumination/light/light_checks.h"

namespace aktina {
namespace {

std::shared_ptr<const PhotometricTable> shared(PhotometricTable table) {
  check(table);
  return std::make_shared<const PhotometricTable>(std::move(table));
}

std::vector<float> steps(float last, int count) {
  std::vector<float> angles;
  for (int i = 0; i <= count; ++i) angles.push_back(last * float(i) / float(count));
  return angles;
}

/// I = peak cos(gamma), the cosine emitter's, in steps of half a degree.
PhotometricTable lambertian(float peak) {
  PhotometricTable table{{0}, steps(90, 180), {}};
  for (const float gamma : table.gamma) table.candela.push_back(peak * std::cos(gamma * float(kPi / 180)));
  table.candela.back() = 0;
  return table;
}

/// Different in every direction, so that mirrored or turned axes show.
PhotometricTable lopsided() {
  PhotometricTable table{steps(360, 24), steps(180, 18), {}};
  for (const float c : table.c)
    for (const float gamma : table.gamma)
      table.candela.push_back(100 + 50 * std::sin(c * float(kPi / 180)) + 20 * std::cos(c * float(kPi / 90)) + gamma);
  return table;
}

Vec3 direction(Vec2 u) {
  const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z)), phi = float(2 * kPi) * u.y;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

TEST(LuminaireLight, ALambertianTableIsTheCosineSpot) {
  const Vec3 axis = normalize(Vec3(1, -2, 0.5f));
  const SpotLight spot{.position = {1, 2, 3},
                       .direction = axis,
                       .intensity = Intensity(Rgb(70)),
                       .inner_angle = float(kPi / 2),
                       .outer_angle = float(kPi / 2),
                       .exponent = 1};
  const LuminaireLight lamp{{1, 2, 3}, axis, Frame(axis).t, Rgb(1), shared(lambertian(70))};
  for (uint32_t i = 0; i < 1000; ++i) {
    const Point3 x = spot.position + 3.0f * direction(sobol_owen(i, 7));
    EXPECT_NEAR(sample(lamp, x).e_perp.v.g, sample(spot, x).e_perp.v.g, 1e-4 * 70 / 9);
  }
  EXPECT_NEAR(flux(lamp)->v.g, 70 * kPi, 70 * kPi * 1e-4);
}

TEST(LuminaireLight, AnIsotropicTableIsThePointLight) {
  const PointLight point{.position = {0, 1, 0}, .intensity = Intensity(Rgb(12))};
  const LuminaireLight lamp{{0, 1, 0}, {0, 0, -1}, {1, 0, 0}, Rgb(1), shared({{0}, {0, 90, 180}, {12, 12, 12}})};
  for (uint32_t i = 0; i < 100; ++i) {
    const Point3 x = 4.0f * direction(sobol_owen(i, 3));
    const LightSample a = sample(lamp, x), b = sample(point, x);
    EXPECT_NEAR(a.e_perp.v.g, b.e_perp.v.g, 1e-6f * b.e_perp.v.g);
    EXPECT_EQ(a.wi, b.wi);
  }
  EXPECT_NEAR(flux(lamp)->v.g, flux(point)->v.g, 1e-4);
  EXPECT_NEAR(flux(LuminaireLight{})->v.g, 4 * kPi, 1e-5) << "without a table: 1 cd all around";
}

TEST(LuminaireLight, UntransformedItStandsAsExtLightsIesHasIt) {
  PhotometricTable table{{0, 90, 180, 270, 360}, {0, 90, 180}, {1, 10, 7, 1, 20, 7, 1, 30, 7, 1, 40, 7, 1, 10, 7}};
  const LuminaireLight lamp{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, Rgb(1), shared(table)};
  EXPECT_FLOAT_EQ(sample(lamp, {0, 0, -1}).e_perp.v.g, 1);
  EXPECT_FLOAT_EQ(sample(lamp, {0, 0, 1}).e_perp.v.g, 7);
  EXPECT_FLOAT_EQ(sample(lamp, {1, 0, 0}).e_perp.v.g, 10) << "C0";
  EXPECT_FLOAT_EQ(sample(lamp, {0, 1, 0}).e_perp.v.g, 20) << "C90";
  EXPECT_FLOAT_EQ(sample(lamp, {-1, 0, 0}).e_perp.v.g, 30) << "C180";
  EXPECT_FLOAT_EQ(sample(lamp, {0, -1, 0}).e_perp.v.g, 40) << "C270";
  EXPECT_FLOAT_EQ(sample(lamp, {0, 2, 0}).e_perp.v.g, 5) << "the inverse square law";
}

TEST(LuminaireLight, AllItsFluxPassesASphereAboutIt) {
  const LuminaireLight lamp{{0.1f, 0, 0}, {0, -1, 0}, {0, 0, 1}, Rgb(2), shared(lopsided())};
  EXPECT_NEAR(test::flux_through_sphere(lamp, 1, 1 << 15), flux(lamp)->v.g, 0.005 * flux(lamp)->v.g);
}

TEST(LuminaireLight, BeyondTheMeasuredAnglesItIsDark) {
  const LuminaireLight lamp{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, Rgb(1), shared({{0}, {0, 60}, {5, 5}})};
  EXPECT_FLOAT_EQ(sample(lamp, {0, 0, -1}).e_perp.v.g, 5);
  EXPECT_EQ(sample(lamp, {1, 0, 0}).e_perp.v.g, 0);
  EXPECT_NEAR(flux(lamp)->v.g, 5 * 2 * kPi * (1 - 0.5), 1e-4) << "the solid angle of a cone";
  EXPECT_TRUE(is_finite(sample(lamp, {0, 0, 0}).e_perp.v));
}

TEST(PhotometricTable, PeakAndFaults) {
  const PeakIntensity most = peak(PhotometricTable{{0, 180, 360}, {0, 90}, {1, 2, 1, 9, 1, 2}});
  EXPECT_EQ(most.candela, 9);
  EXPECT_EQ(most.c, 180);
  EXPECT_EQ(most.gamma, 90);
  for (const PhotometricTable& bad : {
           PhotometricTable{{}, {0, 90}, {}},
           PhotometricTable{{0}, {0}, {1}},
           PhotometricTable{{0}, {0, 90}, {1}},
           PhotometricTable{{0}, {90, 0}, {1, 1}},
           PhotometricTable{{0}, {0, 190}, {1, 1}},
           PhotometricTable{{0, 90}, {0, 90}, {1, 1, 1, 1}},
           PhotometricTable{{0}, {0, 90}, {1, -1}},
           PhotometricTable{{0}, {0, 90}, {1, NAN}},
       })
    EXPECT_THROW(check(bad), Error);
}

}  // namespace
}  // namespace aktina
