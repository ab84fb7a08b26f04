#include "aktina/raster/shading/highlight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/raster/shading/highlight_track.h"

namespace aktina {
namespace {

Vec3 direction(Pcg32& random) {
  const float z = 2 * random.uniform() - 1, phi = 2 * float(kPi) * random.uniform(), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}
Vec3 barycentric(Pcg32& random) {
  const float r = std::sqrt(random.uniform()), s = random.uniform();
  return {1 - r, r * (1 - s), r * s};
}
Vec3 mix(const Vec3 (&v)[3], Vec3 b) { return b.x * v[0] + b.y * v[1] + b.z * v[2]; }

/// Normals within about `spread` of a common direction.
void draw_normals(Pcg32& random, float spread, Vec3 (&n)[3]) {
  const Vec3 common = direction(random);
  for (Vec3& v : n) v = normalize(common + spread * direction(random));
}

TEST(HighlightPeak, OnAnEdgeIsTheMaximumOfAllNormalsBetweenItsEnds) {
  Pcg32 random(1);
  for (int round = 0; round < 300; ++round) {
    const Vec3 a = direction(random), b = direction(random), h = direction(random);
    if (dot(a, b) < -0.95f) continue;
    const EdgePeak peak = edge_peak(a, b, h);
    float most = -1;
    for (int i = 0; i <= 4000; ++i) {
      const float t = float(i) / 4000;
      most = std::max(most, dot(normalize((1 - t) * a + t * b), h));
    }
    EXPECT_NEAR(peak.cosine, most, 1e-5f);
    EXPECT_NEAR(dot(normalize((1 - peak.t) * a + peak.t * b), h), peak.cosine, 1e-5f);
  }
}

TEST(HighlightPeak, OfAnEdgeIsTheClosedForm) {
  // sqrt(1 - (h.m)^2) with m across the edge's great circle, where the peak is inside.
  Pcg32 random(2);
  int inside = 0;
  for (int round = 0; round < 300; ++round) {
    const Vec3 a = direction(random), b = normalize(a + 0.8f * direction(random)), h = direction(random);
    const EdgePeak peak = edge_peak(a, b, h);
    if (peak.t == 0 || peak.t == 1) continue;
    ++inside;
    const float across = dot(h, normalize(cross(a, b)));
    EXPECT_NEAR(peak.cosine, std::sqrt(1 - across * across), 1e-4f);
  }
  EXPECT_GT(inside, 20);
}

TEST(HighlightPeak, OnATriangleIsTheMaximumOfAllItsNormals) {
  Pcg32 random(3);
  int within = 0;
  for (int round = 0; round < 200; ++round) {
    Vec3 n[3];
    draw_normals(random, 0.9f, n);
    const Vec3 h = normalize(mix(n, {0.4f, 0.3f, 0.3f}) + 0.7f * direction(random));
    const float peak = highlight_peak(n, h);
    float most = -1;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; j <= 60 - i; ++j)
        most = std::max(most, dot(normalize(mix(n, Vec3(float(i), float(j), float(60 - i - j)) / 60.0f)), h));
    EXPECT_GE(peak, most - 1e-6f);
    EXPECT_LE(peak, most + 2e-3f);  // the grid's step
    within += peak == 1;
  }
  EXPECT_GT(within, 10);
  EXPECT_LT(within, 190);
}

TEST(HighlightCurve, CosineIsWhereTheHighlightIsAShareOfItsPeak) {
  for (const float exponent : {0.3f, 1.0f, 20.0f, 1e6f})
    for (const float share : {0.002f, 0.3f, 1.0f}) {
      HighlightCurve curve{.power = HighlightCurve::Power::exact, .exponent = exponent};
      EXPECT_NEAR(std::pow(double(curve.cosine_at(share)), double(exponent)), double(share), 0.05 * double(share));
      curve.power = HighlightCurve::Power::schlick;
      EXPECT_NEAR(schlick_power(curve.cosine_at(share), exponent), share, 0.08f * share);
    }
}

TEST(HighlightCurve, ValuesAreTheModels) {
  alignas(64) float values[2 * kLanes];
  const auto cosine = [](size_t i) { return 1 - 1.2f * float(i) / float(2 * kLanes - 1); };
  for (const bool half : {false, true})
    for (const auto power : {HighlightCurve::Power::exact, HighlightCurve::Power::schlick}) {
      const HighlightCurve curve{.power = power, .half = half, .exponent = 30};
      for (size_t i = 0; i < 2 * kLanes; ++i) values[i] = curve.fall(cosine(i));
      highlight_values(curve, values, 2 * kLanes);
      for (size_t i = 0; i < 2 * kLanes; ++i) {
        const float t = std::max(cosine(i), 0.0f);
        const bool exact = power == HighlightCurve::Power::exact;
        EXPECT_NEAR(values[i], exact ? std::pow(t, 30.0f) : schlick_power(t, 30), 1e-4f) << i;
      }
    }
}

TEST(HighlightCurve, ModelsWithoutOneAreRefusedInOneLine) {
  const Light lamp = DirectionalLight{{0, 0, -1}, Irradiance(Rgb(1))};
  for (const IlluminationModel& model : {IlluminationModel(Ggx{}), IlluminationModel(Ward{})}) {
    const Illuminator light(model, Surface(), std::span(&lamp, 1), Rgb(0), {{0, 0, 1}, true});
    for (const char* id :
         {"h_test", "lai_tai", "tai_hsu", "cho_neumann_woo", "brown", "vlasic", "overveld_highlights"}) {
      try {
        make_method(shading_methods(), "shading", id)->plan(light);
        FAIL() << id;
      } catch (const Error& e) {
        EXPECT_EQ(e.code(), Code::unsupported);
        EXPECT_NE(std::string(e.what()).find("blinn_phong"), std::string::npos);
      }
    }
  }
}

/// A triangle with a lamp and a viewer, near or far, and a model.
struct Case {
  Point3 position[3];
  Vec3 normal[3];
  std::vector<Light> lights;
  Viewer viewer;
  Surface surface;
  IlluminationModel model;

  explicit Case(Pcg32& random) {
    const Vec3 up = direction(random);
    const Frame frame(up);
    const float size = std::pow(10.0f, 1.5f * random.uniform() - 1.5f), spread = random.uniform();
    for (int k = 0; k < 3; ++k) {
      position[k] = frame.to_world({size * (random.uniform() - 0.5f), size * (random.uniform() - 0.5f), 0});
      normal[k] = normalize(up + spread * direction(random));
    }
    const Vec3 to_lamp = normalize(up + 1.2f * direction(random)), to_eye = normalize(up + 1.2f * direction(random));
    const float near = 0.3f + 3 * random.uniform();
    if (random.uniform() < 0.4f) {
      lights.push_back(DirectionalLight{-to_lamp, Irradiance(Rgb(2))});
    } else {
      lights.push_back(PointLight{near * to_lamp, Intensity(Rgb(2)), {1, 0, 0, true}});
    }
    viewer = random.uniform() < 0.4f ? Viewer{to_eye, true} : Viewer{(0.3f + 3 * random.uniform()) * to_eye, false};
    surface.kd = Rgb(0), surface.ks = Rgb(1), surface.exponent = std::pow(10.0f, 0.5f + 2 * random.uniform());
    const float which = random.uniform();
    if (which < 0.35f)
      model = BlinnPhong{};
    else if (which < 0.7f)
      model = Phong{};
    else
      model = Schlick{which < 0.85f};
  }
  Illuminator light() const { return {model, surface, lights, Rgb(0), viewer}; }
  /// The highlight over its peak.
  float shine(Vec3 b) const {
    const Point3 x = mix(position, b);
    const Lit lit =
        illuminate(model, surface, lights, Rgb(0), x, normalize_or(mix(normal, b), {0, 0, 1}), viewer.towards(x));
    const float peak = sample(lights[0], x).e_perp.v.g * float(kInvPi);
    return lit.specular.g / peak;
  }
};

TEST(HighlightTest, NoPointOfARejectedTriangleShinesMoreThanTheShare) {
  constexpr float kShare = 1.0f / 512;
  Pcg32 random(4);
  int rejected = 0, dark = 0;
  constexpr int kRounds = 4000;
  for (int round = 0; round < kRounds; ++round) {
    const Case c(random);
    const Illuminator light = c.light();
    const HighlightCurve curve = highlight_curve(light, "test");
    const bool may = may_shine(curve, curve.cosine_at(kShare), light.lamps()[0], c.viewer, c.position, c.normal);
    rejected += !may;
    float most = 0;
    for (int i = 0; i < 60; ++i) most = std::max(most, c.shine(barycentric(random)));
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i <= 10; ++i) {
        Vec3 b(0);
        b[k] = float(i) / 10, b[(k + 1) % 3] = 1 - b[k];
        most = std::max(most, c.shine(b));
      }
    dark += most <= kShare;
    if (!may) {
      EXPECT_LE(most, kShare * 1.01f) << round;
    }
  }
  std::printf("rejected %d of %d triangles; %d of them show no highlight\n", rejected, kRounds, dark);
  EXPECT_GT(rejected, dark * 6 / 10) << "a test that rejects little is of no use";
}

TEST(HighlightTest, NoPointOfATriangleRejectedForItsFacetsShinesMoreThanTheShare) {
  constexpr float kShare = 1.0f / 512;
  Pcg32 random(7);
  int rejected = 0;
  for (int round = 0; round < 2000; ++round) {
    Case c(random);
    const int which = round % 5;
    c.surface.ior = 1e4f, c.surface.roughness = 0.15f + 0.6f * random.uniform();  // Fresnel's factor: 1
    if (which < 4)
      c.model = TorranceSparrow{FacetDistribution(which), 0};
    else
      c.model = CookTorrance{};
    const Illuminator light = c.light();
    const HighlightCurve curve = highlight_curve(light, "test");
    if (may_shine(curve, curve.cosine_at(kShare), light.lamps()[0], c.viewer, c.position, c.normal)) continue;
    ++rejected;
    const float slope = facet_slope(c.surface), along_normal = which < 4 ? 1 : 1 / (slope * slope);
    for (int i = 0; i < 60; ++i) {
      const Vec3 b = barycentric(random);
      const Point3 x = mix(c.position, b);
      const Vec3 wi = sample(c.lights[0], x).wi, wo = c.viewer.towards(x);
      const float peak = 2 * along_normal / dot(wo, half_vector(wi, wo, wo));
      EXPECT_LE(c.shine(b), kShare * 1.02f * peak) << round;
    }
  }
  EXPECT_GT(rejected, 200);
}

TEST(HighlightTest, OfAGroupIsThatOfEachTriangle) {
  Pcg32 random(5);
  int different = 0, count = 0;
  for (int round = 0; round < 100; ++round) {
    const Case shared(random);
    const Illuminator light = shared.light();
    const HighlightCurve curve = highlight_curve(light, "test");
    const float least = curve.cosine_at(0.01f);
    TriangleGroup group{};
    group.count = int(kLanes);
    bool expected[kLanes];
    for (size_t i = 0; i < kLanes; ++i) {
      const Case c(random);
      for (int v = 0; v < 3; ++v)
        for (int k = 0; k < 3; ++k) group.position[v][k][i] = c.position[v][k], group.normal[v][k][i] = c.normal[v][k];
      expected[i] = may_shine(curve, least, light.lamps()[0], shared.viewer, c.position, c.normal);
    }
    const uint32_t bits = may_shine(curve, least, light, group);
    for (size_t i = 0; i < kLanes; ++i) different += expected[i] != bool(bits >> i & 1), ++count;
  }
  EXPECT_LE(different, 2) << "of " << count;  // but for the rounding that both allow for
}

TEST(HighlightTest, LampAndViewerOnTheSurfaceRejectNothingInFrontOfThem) {
  const Point3 position[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3 normal[3] = {normalize(Vec3(0.1f, 0, 1)), normalize(Vec3(0, 0.2f, 1)), {0, 0, 1}};
  const Light inside = PointLight{{0.2f, 0.2f, 0}, Intensity(Rgb(1)), {}};
  const HighlightCurve curve{.power = HighlightCurve::Power::exact, .half = true, .exponent = 50};
  EXPECT_TRUE(may_shine(curve, curve.cosine_at(0.01f), lamp(inside), {{0.3f, 0.3f, 0.001f}, false}, position, normal));
}

TEST(HighlightTrack, IsThePixelsWhoseNormalsLieInTheCone) {
  Pcg32 random(6);
  int partly = 0;
  for (int round = 0; round < 2000; ++round) {
    const Vec3 h = direction(random);
    const float cosine = 1.2f * random.uniform() - 0.2f;
    const Vec3 a = normalize(h + 1.5f * direction(random)) * (0.5f + random.uniform());
    const Vec3 b = normalize(h + 1.5f * direction(random)) * (0.5f + random.uniform());
    constexpr int kCount = 50;
    const HighlightTrack track = highlight_track({h, cosine}, a, b, kCount);
    int on = 0;
    for (int i = 0; i < kCount; ++i) {
      const Vec3 n = a + (b - a) * (float(i) / (kCount - 1));
      const float over = dot(n, h) - cosine * length(n);
      const bool inside = track.begin <= i && i < track.end;
      on += inside;
      if (inside && cosine > 0) {
        EXPECT_GT(over, -1e-3f);
      } else if (!inside) {
        EXPECT_LT(over, 1e-4f);
      }
    }
    partly += on > 0 && on < kCount;
  }
  EXPECT_GT(partly, 300);
}

TEST(HighlightTrack, OfEqualNormalsIsAllOrNothing) {
  const HighlightCone cone{{0, 0, 1}, 0.9f};
  EXPECT_EQ(highlight_track(cone, {0, 0.1f, 1}, {0, 0.1f, 1}, 9).end, 9);
  EXPECT_EQ(highlight_track(cone, {0, 1, 1}, {0, 1, 1}, 9).end, 0);
  EXPECT_EQ(highlight_track(cone, {0, 0, -1}, {0, 0, -1}, 9).end, 0) << "the mirror image of the cone";
}

}  // namespace
}  // namespace aktina
