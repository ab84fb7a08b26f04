// Methods that look for highlights: h_test, cho_neumann_woo, lai_tai, tai_hsu; and those that interpolate what makes
// them: overveld_highlights, vlasic, brown.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/raster/shading/corner_highlight.h"
#include "aktina/raster/shading/shade_triangle.h"

namespace aktina {
namespace {

constexpr const char* kMethods[] = {"h_test", "cho_neumann_woo",     "lai_tai", "tai_hsu",
                                    "vlasic", "overveld_highlights", "brown"};
constexpr float kShare = 1.0f / 512;  // that methods count as none

std::vector<Vec3> points(int count, uint64_t seed = 1) {
  Pcg32 random(seed);
  std::vector<Vec3> out;
  for (int i = 0; i < count; ++i) {
    const float r = std::sqrt(random.uniform()), s = random.uniform();
    out.emplace_back(1 - r, r * (1 - s), r * s);
  }
  return out;
}

/// A triangle whose normals lean apart by about `lean`, with a lamp that has its highlight inside.
struct HighlightMethods : testing::Test {
  Surface surface{.kd = Rgb(0.6f), .ks = Rgb(0.5f), .exponent = 30};
  IlluminationModel model = BlinnPhong{};
  std::vector<Light> lights{DirectionalLight{normalize(Vec3(-0.05f, -0.1f, -1)), Irradiance(Rgb(float(kPi)))}};
  Viewer viewer{{0, 0, 1}, true};
  ShadedTriangle triangle;

  HighlightMethods() { lean(0.5f); }
  void lean(float by) {
    triangle.normal[0] = normalize(Vec3(-by, -by, 1));
    triangle.normal[1] = normalize(Vec3(by, -0.2f * by, 1)), triangle.normal[2] = normalize(Vec3(-0.2f * by, by, 1));
  }
  Illuminator light() const { return {model, surface, lights, Rgb(0.1f), viewer}; }
  std::vector<Lit> shaded(const std::string& method, std::span<const Vec3> at) const {
    return shade(*make_method(shading_methods(), "shading", method), light(), triangle, at);
  }
  Lit shaded(const std::string& method, Vec3 at) const { return shaded(method, std::span(&at, 1))[0]; }
  void expect_equal(const std::string& a, const std::string& b, float tolerance = 2e-5f) const {
    const auto at = points(60);
    const auto x = shaded(a, at), y = shaded(b, at);
    for (size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(x[i].diffuse.g, y[i].diffuse.g, tolerance) << a << ", " << b;
      EXPECT_NEAR(x[i].specular.g, y[i].specular.g, tolerance) << a << ", " << b;
    }
  }
  /// Root mean square of the difference to another method.
  double error(const std::string& a, const std::string& b) const {
    const auto at = points(300);
    const auto x = shaded(a, at), y = shaded(b, at);
    double sum = 0;
    for (size_t i = 0; i < at.size(); ++i) sum += std::pow(double(x[i].total().g - y[i].total().g), 2);
    return std::sqrt(sum / double(at.size()));
  }
};

TEST_F(HighlightMethods, HTestIsPhongsHighlightOverGouraudsDiffuseLight) { expect_equal("h_test", "hybrid"); }

TEST_F(HighlightMethods, HTestIsGouraudWithoutHighlightWhereThereIsNone) {
  lights = {DirectionalLight{normalize(Vec3(1, 0.3f, -0.2f)), Irradiance(Rgb(float(kPi)))}};
  surface.exponent = 200;
  for (const Lit& lit : shaded("h_test", points(40))) EXPECT_EQ(lit.specular.g, 0);
  for (const Lit& lit : shaded("hybrid", points(40))) EXPECT_LE(lit.specular.g, surface.ks.g * kShare);
}

TEST_F(HighlightMethods, LaiTaisTrackIsPhongsHighlightWhereItCountsAndNoneElsewhere) {
  for (const IlluminationModel& of : {IlluminationModel(BlinnPhong{}), IlluminationModel(Phong{})}) {
    model = of, surface.exponent = 90;
    const auto at = points(500);
    const auto track = shaded("lai_tai", at), full = shaded("hybrid", at);
    int on = 0, off = 0;
    for (size_t i = 0; i < at.size(); ++i) {
      if (track[i].specular.g > 0) {
        EXPECT_NEAR(track[i].specular.g, full[i].specular.g, 3e-5f);
        ++on;
      } else {
        EXPECT_LE(full[i].specular.g, surface.ks.g * kShare * 1.02f);
        ++off;
      }
    }
    EXPECT_GT(on, 50);
    EXPECT_GT(off, 50);
  }
}

TEST_F(HighlightMethods, TaiHsusTiersArePhongFenceAndGouraud) {
  expect_equal("tai_hsu:strong=0,weak=0", "hybrid");
  expect_equal("tai_hsu:strong=2,weak=2", "gouraud:perspective=1");
  const std::string fence = "tai_hsu:strong=2,weak=0";
  for (const Vec3 b : {Vec3(0.3f, 0.7f, 0), Vec3(0, 0.2f, 0.8f), Vec3(0, 0.5f, 0.5f)})
    EXPECT_NEAR(shaded(fence, b).specular.g, shaded("phong", b).specular.g, 1e-3f) << "Phong on the edges";
  const Vec3 left(0.6f, 0, 0.4f), right(0, 0.6f, 0.4f), middle = 0.5f * (left + right);  // on one scanline
  EXPECT_NEAR(shaded(fence, middle).specular.g,
              0.5f * (shaded(fence, left).specular.g + shaded(fence, right).specular.g), 1e-3f);
}

TEST_F(HighlightMethods, TaiHsuDiffersFromHybridByNoMoreThanItsThreshold) {
  for (const float by : {0.05f, 0.2f, 0.5f}) {
    lean(by);
    const auto at = points(100);
    const auto tiers = shaded("tai_hsu:strong=0.01", at), full = shaded("hybrid", at);
    for (size_t i = 0; i < at.size(); ++i)
      EXPECT_NEAR(tiers[i].specular.g, full[i].specular.g, 0.011f * surface.ks.g + 1e-5f);
  }
}

TEST_F(HighlightMethods, SubdivisionIsGouraudWhereThereIsNoHighlight) {
  surface.ks = Rgb(0), model = Lambert{};
  expect_equal("cho_neumann_woo:depth=4", "gouraud:perspective=1");
  expect_equal("cho_neumann_woo:depth=0", "gouraud:perspective=1");
}

TEST_F(HighlightMethods, SubdivisionComesNearerToPhongWithEachLevel) {
  double before = error("cho_neumann_woo:depth=0", "phong");
  for (const char* deeper : {"cho_neumann_woo:depth=1", "cho_neumann_woo:depth=2", "cho_neumann_woo:depth=3"}) {
    const double now = error(deeper, "phong");
    EXPECT_LT(now, before) << deeper;
    before = now;
  }
}

TEST_F(HighlightMethods, SubdivisionIsOfSecondOrderInTheDiffuseLight) {
  surface.exponent = 1, surface.ks = Rgb(1e-4f);  // a highlight everywhere that does not show: all is split
  const double coarse = error("cho_neumann_woo:depth=1", "phong"), fine = error("cho_neumann_woo:depth=2", "phong");
  EXPECT_NEAR(coarse / fine, 4, 0.8);
}

TEST_F(HighlightMethods, SubdivisionHasNoCracks) {
  // Two triangles on both sides of an edge, the other one without a highlight of its own inside.
  Pcg32 random(8);
  for (int round = 0; round < 40; ++round) {
    ShadedTriangle a = triangle, b;
    for (Vec3& n : a.normal) n = normalize(Vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, 0.8f));
    b.position[0] = a.position[2], b.position[1] = a.position[1], b.position[2] = {1, 1, 0.3f};
    b.normal[0] = a.normal[2], b.normal[1] = a.normal[1];
    b.normal[2] = normalize(Vec3(random.uniform(), random.uniform(), 0.3f));
    b.screen[0] = a.screen[2], b.screen[1] = a.screen[1], b.screen[2] = {1, 1};
    surface.exponent = 100;
    for (int i = 0; i <= 32; ++i) {
      const float t = float(i) / 32;
      const Vec3 at(0, 1 - t, t), same(t, 1 - t, 0);
      triangle = a;
      const Lit one = shaded("cho_neumann_woo:depth=3", at);
      triangle = b;
      const Lit other = shaded("cho_neumann_woo:depth=3", same);
      EXPECT_NEAR(one.total().g, other.total().g, 1e-4f) << round << ", " << t;
    }
    triangle = a;
  }
}

TEST_F(HighlightMethods, PlacesOfCornersHoldTheirHighlights) {
  Pcg32 random(9);
  const auto unit = [&] {
    return normalize(Vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() - 0.5f) + Vec3(1e-3f));
  };
  for (int round = 0; round < 50; ++round) {
    lights = {PointLight{3.0f * unit(), Intensity(Rgb(1)), {}}};
    viewer = {2.0f * unit(), false};
    for (Vec3& n : triangle.normal) n = unit();
    model = round % 2 ? IlluminationModel(Phong{}) : IlluminationModel(BlinnPhong{});
    TriangleGroup group{};
    for (size_t v = 0; v < 3; ++v)
      for (int k = 0; k < 3; ++k)
        group.position[v][k][0] = triangle.position[v][k], group.normal[v][k][0] = triangle.normal[v][k];
    const Illuminator one = light();
    const HighlightCurve curve = sole_highlight_curve(one, "test");
    const CornerHighlights highlights(curve, one, 0, CornerValues(group, 0));
    const HighlightPlaces places(curve, highlights);
    for (int v = 0; v < 3; ++v) {
      const Vec3 at = places.corner[v];
      EXPECT_NEAR(at.z, dot(highlights.corner[v].normal, highlights.corner[v].half), 3e-5f);
      if (!curve.half || at.z > 0) {
        EXPECT_NEAR(at.x * at.x + at.y * at.y, curve.fall(highlights.corner[v].cosine), 5e-5f);
      }
    }
  }
}

TEST_F(HighlightMethods, OfInfiniteLightsAreBlinnsWithNormalsAsTheyAreInterpolated) {
  // H is the same everywhere: cos^2 = 1 - |n x h|^2 with the linear normal.
  const Vec3 h = normalize(-std::get<DirectionalLight>(lights[0]).direction + viewer.at);
  const auto at = points(50);
  const auto lit = shaded("overveld_highlights", at);
  for (size_t i = 0; i < at.size(); ++i) {
    const Vec3 n = at[i].x * triangle.normal[0] + at[i].y * triangle.normal[1] + at[i].z * triangle.normal[2];
    const float sine2 = dot(cross(n, h), cross(n, h));
    EXPECT_NEAR(lit[i].specular.g, surface.ks.g * std::pow(1 - sine2, surface.exponent / 2), 2e-5f);
  }
}

TEST_F(HighlightMethods, APlaneUnderANearLampCarriesAHighlight) {
  for (Vec3& n : triangle.normal) n = {0, 0, 1};
  lights = {PointLight{{0.3f, 0.3f, 1.6f}, Intensity(Rgb(1)), {1, 0, 0, false}}};
  viewer = {{0.3f, 0.3f, 1.8f}, false};
  surface.exponent = 160;
  const Vec3 inside(0.4f, 0.3f, 0.3f);
  for (const char* method : {"overveld_highlights", "vlasic", "brown"}) {
    const float middle = shaded(method, inside).specular.g;
    for (const Vec3 corner : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
      EXPECT_GT(middle, 3 * shaded(method, corner).specular.g) << method;
    const float within = method == std::string("brown") ? 0.7f : 0.15f;  // a quadratic through six samples
    EXPECT_NEAR(middle, shaded("phong", inside).specular.g, within * middle) << method;
  }
  EXPECT_LT(shaded("gouraud", inside).specular.g, 0.5f * shaded("phong", inside).specular.g);
}

TEST_F(HighlightMethods, VlasicsMapErrsByTheSquareOfTheSpan) {
  surface.exponent = 8, surface.kd = Rgb(0);
  lights = {DirectionalLight{normalize(Vec3(-0.9f, -0.4f, -0.6f)), Irradiance(Rgb(float(kPi)))}};  // H far from N
  lean(0.4f);
  const double wide = error("vlasic", "phong");
  lean(0.2f);
  const double half = error("vlasic", "phong");
  EXPECT_NEAR(wide / half, 4, 1.2);
}

TEST_F(HighlightMethods, BrownsBezierTriangleIsPhongsHighlightAtSixSamples) {
  for (const IlluminationModel& of : {IlluminationModel(BlinnPhong{}), IlluminationModel(Phong{})}) {
    model = of;
    for (const auto& b : lattice(2)) {
      const Vec3 at(b[0], b[1], b[2]);
      EXPECT_NEAR(shaded("brown", at).specular.g, shaded("phong", at).specular.g, 1e-4f);
    }
  }
}

TEST_F(HighlightMethods, BrownsBoundLeavesOutNothingThatCounts) {
  Pcg32 random(10);
  int skipped = 0;
  for (int round = 0; round < 60; ++round) {
    for (Vec3& n : triangle.normal) n = normalize(Vec3(random.uniform() - 0.4f, random.uniform() - 0.4f, 0.7f));
    surface.exponent = 150;
    const auto at = points(30, uint64_t(round));
    const auto some = shaded("brown", at), all = shaded("brown:share=0", at);
    bool none = true;
    for (size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(some[i].specular.g, all[i].specular.g, surface.ks.g * kShare * 1.01f);
      none = none && some[i].specular.g == 0;
    }
    skipped += none;
  }
  EXPECT_GT(skipped, 3);
  EXPECT_LT(skipped, 50);
}

TEST_F(HighlightMethods, LampsAddUp) {
  const Light red = PointLight{{1, 0.5f, 2}, Intensity({5, 0, 0}), {}};
  const Light green =
      SpotLight{{-0.5f, 1, 1.5f}, normalize(Vec3(0.6f, -0.5f, -1)), Intensity({0, 6, 1}), 0.2f, 1.2f, 0, {}};
  const auto at = points(50);
  for (const char* method : kMethods) {
    lights = {red};
    const auto first = shaded(method, at);
    lights = {green};
    const auto second = shaded(method, at);
    lights = {red, green};
    const auto both = shaded(method, at);
    for (size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(both[i].specular.r, first[i].specular.r, 0.02f) << method;
      EXPECT_NEAR(both[i].specular.g, second[i].specular.g, 0.02f) << method;
      EXPECT_EQ(first[i].specular.g, 0) << method;
    }
  }
}

TEST_F(HighlightMethods, AreFiniteWhateverTheExponentLampAndTriangle) {
  const Light on_surface = PointLight{{0.25f, 0.25f, 0}, Intensity(Rgb(1)), {}};
  const Light at_corner = PointLight{{1, 0, 0}, Intensity(Rgb(1)), {}};
  ShadedTriangle point = triangle;
  for (Point3& p : point.position) p = {0.2f, 0.2f, 0};
  ShadedTriangle backs = triangle;
  backs.normal[0] = {0, 0, -1}, backs.normal[1] = {1, 0, 0}, backs.normal[2] = {-1, 0, 0};
  const auto at = points(20);
  for (const char* method : kMethods)
    for (const float exponent : {0.0f, -5.0f, 1e6f, 30.0f})
      for (const Light& lamp : {on_surface, at_corner, lights[0]})
        for (const ShadedTriangle& of : {triangle, point, backs})
          for (const IlluminationModel& with :
               {IlluminationModel(Phong{}), IlluminationModel(BlinnPhong{}), IlluminationModel(Schlick{true})}) {
            surface.exponent = exponent;
            const Viewer near{{0.3f, 0.3f, 0}, false};
            const Illuminator light(with, surface, std::span(&lamp, 1), Rgb(0.1f), near);
            for (const Lit& lit : shade(*make_method(shading_methods(), "shading", method), light, of, at))
              EXPECT_TRUE(std::isfinite(lit.total().g) && lit.total().g >= -1e-6f) << method << ", " << exponent;
          }
}

}  // namespace
}  // namespace aktina
