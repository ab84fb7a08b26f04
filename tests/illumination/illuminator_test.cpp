#include "aktina/illumination/illuminator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr size_t kPoints = 64;

struct alignas(64) Arrays {
  float position[3][kPoints], normal[3][kPoints], ka[3][kPoints], kd[3][kPoints], ks[3][kPoints], exponent[kPoints];
  float diffuse[3][kPoints], specular[3][kPoints];
  Surface whole[kPoints];
  PointArrays points(const SurfaceArrays* surface) const {
    return {kPoints, {position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}, surface};
  }
  SurfaceArrays surface() const {
    return {{ka[0], ka[1], ka[2]}, {kd[0], kd[1], kd[2]}, {ks[0], ks[1], ks[2]}, exponent, whole};
  }
  LitArrays lit() { return {{diffuse[0], diffuse[1], diffuse[2]}, {specular[0], specular[1], specular[2]}}; }
};

Vec3 direction(Pcg32& random) {
  const float z = 2 * random.uniform() - 1, phi = 6.2831853f * random.uniform(), r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}
Vec3 vector(Pcg32& random, float size) {
  return size * Vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() - 0.5f);
}
Rgb colour(Pcg32& random) { return {random.uniform(), random.uniform(), random.uniform()}; }

Attenuation attenuation(Pcg32& random) {
  switch (random.next() % 3) {
    case 0:
      return {};
    case 1:
      return {random.uniform(), random.uniform(), random.uniform(), true};
    default:
      return {0.1f + random.uniform(), random.uniform(), random.uniform(), false};
  }
}

LuminaireLight luminaire(Pcg32& random, Point3 position, Rgb colour) {
  PhotometricTable table{{0, 90, 210, 360}, {0, 20, 60, 90, 120, 180}, {}};
  for (size_t i = 0; i < 24; ++i) table.candela.push_back(random.uniform());
  const Vec3 axis = direction(random);
  return {position, axis, Frame(axis).t, colour, std::make_shared<const PhotometricTable>(std::move(table))};
}

Light light(Pcg32& random, size_t kind) {
  const Point3 position = vector(random, 10);
  const Rgb c = colour(random) * 50;
  switch (kind) {
    case 0:
      return PointLight{position, Intensity(c), attenuation(random)};
    case 1:
      return DirectionalLight{direction(random), Irradiance(c)};
    case 2:
      return luminaire(random, position, c);
    case 4: {
      WarnLight warn{.position = position, .direction = direction(random), .intensity = Intensity(c)};
      warn.exponent = random.next() % 2 ? 0 : 20 * random.uniform();
      warn.cone_angle = random.next() % 2 ? float(kPi) : 1.5f * random.uniform();
      warn.flap_low.y = -1, warn.flap_high.x = 1.5f;
      warn.attenuation = attenuation(random);
      return warn;
    }
    case 5:
      return RectangleLight{position, vector(random, 3), vector(random, 3), Radiance(c), random.next() % 2 == 0};
    case 6:
      return DiscLight{position, direction(random), 2 * random.uniform(), Radiance(c), random.next() % 2 == 0};
    default: {
      SpotLight spot;
      spot.position = position, spot.direction = direction(random), spot.intensity = Intensity(c);
      spot.outer_angle = 0.1f + 1.4f * random.uniform();
      spot.inner_angle = random.next() % 2 ? spot.outer_angle : spot.outer_angle * 0.8f * random.uniform();
      spot.exponent = random.next() % 2 ? 0 : 20 * random.uniform();
      spot.attenuation = attenuation(random);
      return spot;
    }
  }
}

/// Whether a rounding decides on which side of the edge of a hard cone a point lies.
bool on_cone_edge(const Light& light, Point3 x) {
  if (const auto* warn = std::get_if<WarnLight>(&light))
    return std::abs(dot(normalize(x - warn->position), warn->direction) - std::cos(warn->cone_angle)) < 1e-5f;
  const auto* spot = std::get_if<SpotLight>(&light);
  return spot && std::abs(dot(normalize(x - spot->position), spot->direction) - std::cos(spot->outer_angle)) < 1e-5f;
}

/// Every model under every kind of light, against the readable form, at random points.
class IlluminatorTest : public testing::TestWithParam<std::tuple<size_t, size_t, bool>> {};

TEST_P(IlluminatorTest, AgreesWithTheScalarEquation) {
  const auto [model_index, light_kind, textured] = GetParam();
  const auto* row = illumination_models()[model_index];
  const IlluminationModel model = row->make(ParamSet(row->info));
  Pcg32 random(17 + model_index, light_kind);
  Arrays a;
  for (int round = 0; round < 200; ++round) {
    Surface surface;
    surface.ka = colour(random), surface.kd = colour(random), surface.ks = colour(random);
    surface.exponent = std::exp2(10 * random.uniform()) - 1;
    const Light lights[] = {light(random, light_kind), light(random, light_kind)};
    const Rgb ambient = colour(random);
    const Viewer viewer = random.next() % 2 ? Viewer{vector(random, 10), false} : Viewer{direction(random), true};
    for (size_t i = 0; i < kPoints; ++i) {
      const Vec3 x = vector(random, 4), n = direction(random) * (0.5f + random.uniform());
      const Rgb ka = colour(random), kd = colour(random), ks = colour(random);
      for (int k = 0; k < 3; ++k) {
        a.position[k][i] = x[k], a.normal[k][i] = n[k];
        a.ka[k][i] = ka[k], a.kd[k][i] = kd[k], a.ks[k][i] = ks[k];
      }
      a.exponent[i] = 100 * random.uniform();
      a.whole[i].ka = ka, a.whole[i].kd = kd, a.whole[i].ks = ks, a.whole[i].exponent = a.exponent[i];
      a.whole[i].roughness = 0.2f + 0.8f * random.uniform(), a.whole[i].base = kd;
    }
    const SurfaceArrays arrays = a.surface();
    Illuminator(model, surface, lights, ambient, viewer).evaluate(a.points(textured ? &arrays : nullptr), a.lit());
    for (size_t i = 0; i < kPoints; ++i) {
      const Point3 x{a.position[0][i], a.position[1][i], a.position[2][i]};
      if (on_cone_edge(lights[0], x) || on_cone_edge(lights[1], x)) continue;
      const Vec3 n = normalize(Vec3(a.normal[0][i], a.normal[1][i], a.normal[2][i]));
      if (textured) {
        surface = a.whole[i];
      }
      const Lit expected = illuminate(model, surface, lights, ambient, x, n, viewer.towards(x));
      // the edge of a narrow cone; the sum over the edges of a small or distant rectangle
      const float steep = light_kind == 5 ? 1e-3f : light_kind >= 3 ? 2e-4f : 2e-5f;
      // a power n amplifies the error of its cosine n times, a quotient by the cosine that of a grazing viewer
      const float relative = steep + 2e-5f + 1e-6f * surface.exponent + 2e-7f / std::abs(dot(n, viewer.towards(x)));
      float peak = 0;  // radiance where all cosines are 1: r.v, a difference, is off by an absolute error
      for (const Light& l : lights) peak += max_channel(sample(l, x).e_perp.v) / float(kPi);
      for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(a.diffuse[k][i], expected.diffuse[k], steep * (1e-2f + expected.diffuse[k])) << row->info.id;
        ASSERT_NEAR(a.specular[k][i], expected.specular[k], relative * (1e-2f + expected.specular[k] + 0.05f * peak))
            << row->info.id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ModelsLightsTextures, IlluminatorTest,
                         testing::Combine(testing::Range(size_t(0), illumination_models().size()),
                                          testing::Range(size_t(0), lights().size()), testing::Bool()));

TEST(Illuminator, DepthCueingFadesAllButAmbientLight) {
  Arrays a{};
  Pcg32 random(3);
  for (size_t i = 0; i < kPoints; ++i)
    for (int k = 0; k < 3; ++k) a.position[k][i] = vector(random, 6)[k], a.normal[k][i] = direction(random)[k];
  const Light lamp = PointLight{{1, 2, 3}, Intensity(Rgb(40)), {}};
  Viewer viewer{{0, 0, 9}, false};
  viewer.cue = {0.5f, 0.25f, {0, 0, 9}, {0, 0, -1}};
  for (const auto* row : illumination_models()) {
    const IlluminationModel model = row->make(ParamSet(row->info));
    const Surface surface{.ks = Rgb(0.5f), .exponent = 8};
    Illuminator(model, surface, std::span(&lamp, 1), Rgb(0.3f), viewer).evaluate(a.points(nullptr), a.lit());
    for (size_t i = 0; i < kPoints; ++i) {
      const Point3 x{a.position[0][i], a.position[1][i], a.position[2][i]};
      const Vec3 n = normalize(Vec3(a.normal[0][i], a.normal[1][i], a.normal[2][i]));
      const float cue = 1 / (0.5f + 0.25f * (9 - x.z));
      const Lit plain = illuminate(model, surface, std::span(&lamp, 1), Rgb(0.3f), x, n, viewer.towards(x));
      const Lit faded = illuminate(model, surface, std::span(&lamp, 1), Rgb(0.3f), x, n, viewer.towards(x), cue);
      const float ambient = 0.3f;
      EXPECT_NEAR(faded.diffuse.g, ambient + (plain.diffuse.g - ambient) * cue, 1e-5f) << row->info.id;
      EXPECT_NEAR(a.diffuse[1][i], faded.diffuse.g, 1e-4f * (1 + faded.diffuse.g)) << row->info.id;
      EXPECT_NEAR(a.specular[1][i], faded.specular.g, 2e-4f * (1 + faded.specular.g)) << row->info.id;
    }
  }
}

TEST(Illuminator, IsFiniteWhereGeometryDegenerates) {
  Arrays a{};
  for (size_t i = 0; i < kPoints; ++i) {
    a.normal[2][i] = i % 2 ? 1.0f : 0.0f;  // zero normals
    a.position[0][i] = i % 4 < 2 ? 0 : 1;  // the lamp's own place, and the viewer's
  }
  for (const auto* row : illumination_models())
    for (const float exponent : {0.0f, -3.0f, 1e6f}) {
      Surface surface;
      surface.ks = Rgb(1), surface.exponent = exponent;
      SpotLight closed, open;
      closed.outer_angle = 0, open.outer_angle = float(kPi);
      const Light lights[] = {PointLight{},
                              closed,
                              open,
                              DirectionalLight{},
                              WarnLight{.cone_angle = 0},
                              RectangleLight{},
                              RectangleLight{.corner = {0, 0, 0}, .edge_u = {1, 0, 0}},
                              RectangleLight{.edge_v = {0, 0, 0}},
                              DiscLight{},
                              DiscLight{.radius = 1},
                              DiscLight{.radius = 0}};
      Illuminator(row->make(ParamSet(row->info)), surface, lights, Rgb(1), {{1, 0, 0}, false})
          .evaluate(a.points(nullptr), a.lit());
      for (size_t i = 0; i < kPoints; ++i)
        for (int k = 0; k < 3; ++k) {
          EXPECT_TRUE(std::isfinite(a.diffuse[k][i])) << row->info.id << " " << exponent << " " << i;
          EXPECT_TRUE(std::isfinite(a.specular[k][i])) << row->info.id << " " << exponent << " " << i;
        }
    }
}

}  // namespace
}  // namespace aktina
