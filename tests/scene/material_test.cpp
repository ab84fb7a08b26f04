#include "aktina/scene/material.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "aktina/illumination/model.h"
#include "aktina/scene/scene.h"

namespace aktina {
namespace {

Material plastic(float roughness) {
  Material m;
  m.base_colour = {0.2f, 0.4f, 0.6f};
  m.metallic = 0, m.roughness = roughness;
  return m;
}

TEST(MaterialMapping, BodyAndGlossReflectAsIfTheyWereMatt) {
  Material m = plastic(1);
  m.specular_weight = 0;
  EXPECT_EQ(matt_reflectance(m), Rgb(0.2f, 0.4f, 0.6f)) << "no gloss: the base colour";
  EXPECT_NEAR(matt_reflectance(plastic(1)).r, 0.2 * 0.96 + 0.04, 1e-6) << "what the facets leave, and the facets";
  EXPECT_EQ(matt_reflectance(plastic(0.05f)), Rgb(0.2f, 0.4f, 0.6f)) << "a sharp mirror is not matt";
  Material metal = plastic(1);
  metal.metallic = 1;
  EXPECT_EQ(matt_reflectance(metal), Rgb(0.2f, 0.4f, 0.6f));
  metal.roughness = 0.05f;
  EXPECT_EQ(matt_reflectance(metal), Rgb(0));
}

// The highlight of the classic form is as bright as the microfacet lobe D F / 4 at normal incidence, D = 1 / (pi
// alpha^2).
TEST(MaterialMapping, HighlightKeepsItsPeak) {
  const Material m = plastic(0.6f);
  const Vec3 n(0, 0, 1);
  const float alpha2 = 0.6f * 0.6f * 0.6f * 0.6f;
  EXPECT_NEAR(Phong{}.brdf(surface_of(m), n, n, n).specular.g, 0.04 / (4 * kPi * alpha2), 1e-4);
}

// The energy that a highlight reflects at normal incidence is about the reflectance F0, however wide it is.
TEST(MaterialMapping, HighlightKeepsItsEnergy) {
  for (const float roughness : {0.5f, 0.6f, 0.7f}) {
    const Surface s = surface_of(plastic(roughness));
    const float albedo = s.ks.r * 2 / (s.exponent + 1);  // integral of ks (r.wo)^n / pi over the hemisphere
    EXPECT_NEAR(albedo, 0.04, 0.01) << roughness;
  }
}

TEST(MaterialMapping, MirrorsAreSharpSurfacesOnly) {
  EXPECT_NEAR(surface_of(plastic(0)).kr.r, 0.04, 1e-6);
  EXPECT_EQ(surface_of(plastic(0.3f)).kr, Rgb(0));
  Material glass = plastic(0);
  glass.base_colour = Rgb(1), glass.transmission = 1;
  EXPECT_NEAR(surface_of(glass).kt.g, 0.96, 1e-6);
  EXPECT_EQ(surface_of(glass).kd, Rgb(0));
}

// material_of undoes surface_of wherever no coefficient was clipped.
TEST(MaterialMapping, RoundTrip) {
  EXPECT_TRUE(rc::check([] {
    const auto unit = [] { return float(*rc::gen::inRange(0, 1001)) / 1000; };
    Material m;
    m.base_colour = {unit(), unit(), unit()};
    m.metallic = 0, m.roughness = 0.5f + 0.5f * unit();
    m.specular_weight = 0.2f + 0.8f * unit();
    const Surface there = surface_of(m);
    const ClassicMaterial classic{there.ka, there.kd, there.ks, there.kr, there.kt, there.exponent, 1};
    Material back = material_of(classic);
    back.classic.reset();
    const Surface again = surface_of(back);
    for (int k = 0; k < 3; ++k) {
      RC_ASSERT(std::abs(again.kd[k] - there.kd[k]) < 1e-6f);
      RC_ASSERT(std::abs(again.ks[k] - there.ks[k]) < 1e-5f);
    }
    RC_ASSERT(std::abs(again.exponent - there.exponent) < 1e-3f * (1 + there.exponent));
    RC_ASSERT(std::abs(back.roughness - m.roughness) < 1e-4f);
  }));
}

TEST(MaterialMapping, StatedCoefficientsAreKept) {
  const ClassicMaterial classic{Rgb(0.1f), {0.5f, 0.4f, 0.3f}, Rgb(0.9f), Rgb(0.25f), Rgb(0.125f), 37, 1.3f};
  const Surface s = surface_of(material_of(classic));
  EXPECT_EQ(s.ka, classic.ka);
  EXPECT_EQ(s.kd, classic.kd);
  EXPECT_EQ(s.ks, classic.ks);
  EXPECT_EQ(s.kr, classic.kr);
  EXPECT_EQ(s.kt, classic.kt);
  EXPECT_EQ(s.exponent, 37);
  EXPECT_EQ(s.ior, 1.3f);
}

TEST(MaterialMapping, CoefficientsAreReflectances) {
  EXPECT_TRUE(rc::check([] {
    const auto any = [] { return float(*rc::gen::inRange(0, 101)) / 100; };
    Material m;
    m.base_colour = {any(), any(), any()};
    m.metallic = any(), m.roughness = any(), m.transmission = any(), m.specular_weight = any();
    m.specular_tint = Rgb(3 * any()), m.ior = 1 + 3 * any();
    const Surface s = surface_of(m);
    for (const Rgb c : {s.ka, s.kd, s.ks, s.kr, s.kt}) RC_ASSERT(min_channel(c) >= 0 && max_channel(c) <= 1);
    RC_ASSERT(s.exponent >= 0 && std::isfinite(s.exponent));
    RC_ASSERT(max_channel(matt_reflectance(m) + s.kt) <= 1 + 1e-6f);
  }));
}

TEST(Evaluate, TexturesAndVertexColoursMultiply) {
  Scene scene;
  scene.images.emplace_back().pixels = Bitmap{1, 1, 4, true, {51, 102, 204, 128}};
  Material m = plastic(0.8f);
  m.base_colour = Rgb(1);
  m.base_texture.image = m.metallic_roughness_texture.image = m.emission_texture.image = 0;
  m.emission = Radiance(Rgb(10));
  m.alpha_mode = AlphaMode::blend;
  const Vec2 uv[2] = {};
  const MaterialPoint p = evaluate(scene, m, uv, {1, 0.5f, 1, 0.5f});
  EXPECT_NEAR(p.surface.base.r, 0.2, 1e-6);
  EXPECT_NEAR(p.surface.base.g, 0.2, 1e-6);
  EXPECT_NEAR(p.surface.kd.b, 0.8, 1e-6);
  EXPECT_NEAR(p.surface.roughness, 0.8 * 0.4, 1e-6) << "green";
  EXPECT_NEAR(p.emission.v.r, 2, 1e-5);
  EXPECT_NEAR(p.alpha, 128 / 255.0 / 2, 1e-6);
  m.alpha_mode = AlphaMode::mask;
  EXPECT_EQ(evaluate(scene, m, uv, Vec4(1)).alpha, 1) << "128 / 255 passes the cutoff of 0.5";
  m.alpha_cutoff = 0.6f;
  EXPECT_EQ(evaluate(scene, m, uv, Vec4(1)).alpha, 0);
}

TEST(Evaluate, UnlitShowsItsBaseColourOnly) {
  Material m = plastic(0.2f);
  m.unlit = true;
  const Vec2 uv[2] = {};
  const MaterialPoint p = evaluate(Scene{}, m, uv, Vec4(1));
  EXPECT_EQ(p.emission.v, m.base_colour);
  for (const Rgb c : {p.surface.ka, p.surface.kd, p.surface.ks, p.surface.kr, p.surface.kt}) EXPECT_EQ(c, Rgb(0));
}

}  // namespace
}  // namespace aktina
