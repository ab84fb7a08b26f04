#include "aktina/raster/shading/fast_phong.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

const Vec2 kScreen[3] = {{0, 0}, {3, 19}, {20, 2}};
const Vec3 kNormals[3] = {{0, 0, 1}, normalize(Vec3(0.4f, 0, 1)), normalize(Vec3(0, 0.45f, 1))};
const Vec3d kLight = normalize(Vec3d(0.3, -0.2, 1));

double exact(const LinearVector& a, const LinearVector& b, double x, double y) {
  return dot(normalize(a.x * x + a.y * y + a.c), normalize(b.x * x + b.y * y + b.c));
}

TEST(FastPhong, SeriesIsThePublishedOneForAConstantLight) {
  const LinearVector n = linear_vector(kScreen, kNormals);
  const Taylor2 t = cosine_series(n, {Vec3d(0), Vec3d(0), kLight});
  const auto published = bishop_weimer_terms(n, kLight);
  const double ours[] = {t.c, t.y, t.x, t.yy, t.xy, t.xx};
  for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(ours[i], published[i], 1e-12);
}

TEST(FastPhong, ErrorFallsEightfoldWhenDistanceHalves) {
  Vec3 lamps[3];
  for (int k = 0; k < 3; ++k) lamps[k] = normalize(Vec3(0.3f, 0.1f * float(k), 1));  // a lamp nearby: it turns, too
  for (const LinearVector& l : {LinearVector{Vec3d(0), Vec3d(0), kLight}, linear_vector(kScreen, lamps)}) {
    const LinearVector n = linear_vector(kScreen, kNormals);
    const Taylor2 t = cosine_series(n, l);
    const auto error = [&](double r) {
      double sum = 0;
      for (double phi = 0; phi < 2 * kPi; phi += kPi / 8) {
        const double x = r * std::cos(phi), y = r * std::sin(phi);
        sum += std::abs(t.at(x, y) - exact(n, l, x, y));
      }
      return sum;
    };
    EXPECT_NEAR(error(8) / error(4), 8, 1);
    EXPECT_NEAR(error(1) / error(0.5), 8, 0.1);
  }
}

TEST(FastPhong, ForwardDifferencesAreThePolynomial) {
  const Taylor2 t = cosine_series(linear_vector(kScreen, kNormals), {Vec3d(0), Vec3d(0), kLight});
  const auto differences = forward_differences(t, -7.5, 2, 40);
  for (size_t i = 0; i < 40; ++i) EXPECT_NEAR(differences[i], t.at(-7.5 + double(i), 2), 1e-12);
}

TEST(FastPhong, IsExactWhereNormalsDoNotTurn) {
  const Vec3 same[3] = {kNormals[1], kNormals[1], kNormals[1]};
  const Taylor2 t = cosine_series(linear_vector(kScreen, same), {Vec3d(0), Vec3d(0), kLight});
  EXPECT_NEAR(t.at(30, -20), dot(Vec3d(kNormals[1]), kLight), 1e-7);
}

struct FastPhongPicture : testing::Test {
  Surface surface{.kd = Rgb(0.7f), .ks = Rgb(0.5f), .exponent = 10};
  std::vector<Light> lamps{DirectionalLight{normalize(Vec3(-0.3f, 0.2f, -1)), Irradiance(Rgb(3))}};
  Viewer viewer{{0, 0, 1}, true};
  ShadedTriangle triangle;
  FastPhongPicture() { turn(1); }
  void turn(float share) {
    for (int v = 0; v < 3; ++v) triangle.screen[v] = kScreen[v];
    triangle.normal[1] = normalize(Vec3(0.4f * share, 0, 1)), triangle.normal[2] = normalize(Vec3(0, 0.45f * share, 1));
  }
  float at(Vec3 b, const char* method, const IlluminationModel& model) const {
    const Illuminator light(model, surface, lamps, Rgb(0.1f), viewer);
    return shade(*make_method(shading_methods(), "shading", method), light, triangle, std::span(&b, 1))[0].total().g;
  }
};

TEST_F(FastPhongPicture, IsPhongAtTheCentreAndFarFromItOnlyNearly) {
  const Vec3 centre(1.0f / 3);
  for (const IlluminationModel& model : {IlluminationModel(Phong{}), IlluminationModel(BlinnPhong{})}) {
    EXPECT_NEAR(at(centre, "fast_phong", model), at(centre, "phong", model), 1e-4f);
    EXPECT_NEAR(at({1, 0, 0}, "fast_phong", model), at({1, 0, 0}, "phong", model), 0.05f);
    EXPECT_GT(std::abs(at({1, 0, 0}, "fast_phong", model) - at({1, 0, 0}, "phong", model)), 1e-4f);
  }
}

TEST_F(FastPhongPicture, JumpsAtEdgesFallEightfoldWithTheTurnOfNormals) {
  surface.ks = Rgb(0);
  double error[2];
  for (const int k : {0, 1}) {
    turn(k == 0 ? 1 : 0.5f);
    error[k] = std::abs(at({0, 0.5f, 0.5f}, "fast_phong", Lambert{}) - at({0, 0.5f, 0.5f}, "phong", Lambert{})) +
               std::abs(at({1, 0, 0}, "fast_phong", Lambert{}) - at({1, 0, 0}, "phong", Lambert{}));
  }
  EXPECT_GT(error[0] / error[1], 5);
}

TEST_F(FastPhongPicture, NearLampsAndViewersBelongToTheSeries) {
  lamps = {PointLight{{3, 3, 8}, Intensity(Rgb(200)), {}}};
  viewer = {{0.2f, 0.1f, 4}, false};
  for (const Vec3 b : {Vec3(0.3f, 0.4f, 0.3f), Vec3(0.5f, 0.2f, 0.3f)})
    EXPECT_NEAR(at(b, "fast_phong", BlinnPhong{}), at(b, "phong", BlinnPhong{}), 0.02f * at(b, "phong", BlinnPhong{}));
}

}  // namespace
}  // namespace aktina
