#include "aktina/raster/shading/shade_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"

namespace aktina {
namespace {

Vec3 barycentric(Pcg32& random) {
  const float r = std::sqrt(random.uniform()), s = random.uniform();
  return {1 - r, r * (1 - s), r * s};
}

TEST(Lagrange, ReproducesPolynomialsOfItsDegree) {
  Pcg32 random(3);
  for (int degree = 0; degree <= 3; ++degree)
    for (int round = 0; round < 20; ++round) {
      const float a = random.uniform(), b = random.uniform();
      const auto polynomial = [&](float s, float t) { return std::pow(0.3f + a * s - b * t, float(degree)); };
      const auto points = lattice(degree);
      const Vec3 at = barycentric(random);
      float weights[kMostLatticePoints], sum = 0, one = 0;
      lagrange(degree, at, std::span(weights, points.size()));
      for (size_t i = 0; i < points.size(); ++i) {
        sum += weights[i] * polynomial(points[i][1], points[i][2]);
        one += weights[i];
      }
      EXPECT_NEAR(one, 1, 1e-5f);
      EXPECT_NEAR(sum, polynomial(at.y, at.z), 2e-5f) << degree;
    }
}

struct Fixture {
  Surface surface{.kd = Rgb(0.6f), .ks = Rgb(0.3f), .exponent = 12};
  std::vector<Light> lights{PointLight{{0.3f, 0.2f, 2}, Intensity(Rgb(5))}};
  Illuminator light{Phong{}, surface, lights, Rgb(0.1f), {{0, 0, 3}, false}};
  ShadedTriangle triangle;
  Fixture() {
    triangle.normal[1] = normalize(Vec3(0.4f, 0, 1)), triangle.normal[2] = normalize(Vec3(0, 0.5f, 1));
    triangle.weight[0] = 1, triangle.weight[1] = 0.6f, triangle.weight[2] = 0.3f;
  }
  Lit exact(Point3 p, Vec3 n) const {
    return illuminate(Phong{}, surface, lights, Rgb(0.1f), p, normalize(n), light.viewer().towards(p));
  }
};

TEST(ShadeTriangle, PhongEvaluatesTheModelWithThePerspectiveNormal) {
  const Fixture f;
  Pcg32 random(5);
  const auto method = make_method(shading_methods(), "shading", "phong");
  for (int i = 0; i < 20; ++i) {
    const Vec3 b = barycentric(random);
    const ShadedTriangle& t = f.triangle;
    const Vec3 w(b.x * t.weight[0], b.y * t.weight[1], b.z * t.weight[2]), s = w / (w.x + w.y + w.z);
    const Lit expected = f.exact(s.x * t.position[0] + s.y * t.position[1] + s.z * t.position[2],
                                 s.x * t.normal[0] + s.y * t.normal[1] + s.z * t.normal[2]);
    const Lit lit = shade(*method, f.light, t, std::span(&b, 1))[0];
    EXPECT_NEAR(lit.total().g, expected.total().g, 1e-4f * (1 + expected.total().g));
  }
}

TEST(ShadeTriangle, EveryMethodGivesTheVerticesTheirOwnLight) {
  // But for constant shading, which has one value for all, series about the centre, and approximate powers.
  const Fixture f;
  const Vec3 corners[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const ShadingRow* row : shading_methods()) {
    if (row->info.id == "flat" || row->info.id == "fast_phong" || row->info.id == "angular_power") continue;
    const auto lit = shade(*row->make(ParamSet(row->info)), f.light, f.triangle, corners);
    for (size_t v = 0; v < 3; ++v) {
      const Lit expected = f.exact(f.triangle.position[v], f.triangle.normal[v]);
      EXPECT_NEAR(lit[v].diffuse.g, expected.diffuse.g, 1e-4f) << row->info.id;
      EXPECT_NEAR(lit[v].specular.g, expected.specular.g, 1e-4f) << row->info.id;
    }
  }
}

}  // namespace
}  // namespace aktina
