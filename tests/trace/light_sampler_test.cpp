#include "aktina/trace/light_sampler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/trace/trace.h"
#include "trace/integrator/light_scenes.h"

namespace aktina {
namespace {

TEST(LightTree, ChancesAreThoseOfPickAndSumToOne) {
  Pcg32 random(5);
  std::vector<LampBounds> lamps(300);
  for (LampBounds& lamp : lamps) {
    lamp.box.add({9 * random.uniform(), 3 * random.uniform(), 9 * random.uniform()});
    lamp.power = random.uniform() < 0.1f ? 0 : random.uniform();
    lamp.axis = normalize(Vec3(random.uniform() - 0.5f, random.uniform() - 0.5f, random.uniform() - 0.5f));
    lamp.spread = random.uniform() < 0.5f ? 0 : float(kPi);
  }
  LightTree tree;
  tree.build(lamps);
  for (int round = 0; round < 20; ++round) {
    const Point3 x = {9 * random.uniform(), 3 * random.uniform(), 9 * random.uniform()};
    double sum = 0;
    for (uint32_t i = 0; i < lamps.size(); ++i) {
      const float chance = tree.chance(x, i);
      if (lamps[i].power == 0) {
        EXPECT_EQ(chance, 0);
      }
      sum += double(chance);
    }
    EXPECT_NEAR(sum, 1, 1e-4);
    for (int k = 0; k < 50; ++k) {
      const LightTree::Choice c = tree.pick(x, random.uniform());
      EXPECT_NEAR(c.chance, tree.chance(x, c.lamp), 1e-6f);
    }
  }
}

TEST(LightSampler, EveryKindOfLightCanBeSampled) {
  Scene scene;
  for (const auto* row : lights()) scene.lights.push_back({"", row->make(ParamSet(row->info)), -1});
  Instance floor;
  floor.primitive = 0;
  scene.primitives.emplace_back(Disc{});
  scene.instances.push_back(floor);
  scene.cameras.push_back(look_at({0, 2, 0.1f}, {0, 0, 0}, {0, 1, 0}, 0.5f));
  for (const char* integrator : {"whitted", "direct", "path"}) {
    TraceOptions options;
    options.integrator = integrator, options.samples = 1;
    const LayeredImage picture = trace(scene, scene.cameras[0], 4, 4, options);
    for (const float value : picture.layers[0].image.pixels) EXPECT_TRUE(std::isfinite(value)) << integrator;
  }
}

TEST(LightSampler, ManyLampsCostLittleMoreNoiseThanOne) {
  // A corridor of 200 lamps: near ones matter, and are picked more often than by their power alone.
  Scene scene;
  for (int i = 0; i < 200; ++i)
    scene.lights.push_back({"", PointLight{{float(i) * 3, 2.5f, 0}, Intensity(Rgb(10)), {}}, -1});
  const LightSampler lights(scene);
  double truth = 0;
  for (const PlacedLight& l : scene.lights) {
    const LightSample s = sample(l.light, Point3(30, 0, 0));
    truth += double(s.e_perp.v.g * s.wi.y);
  }
  RunningStatistics e;
  for (uint32_t i = 0; i < 4096; ++i) {
    const ArrivingLight s = lights.sample({30, 0, 0}, van_der_corput_owen(i, 3), Vec2(0));
    e.add(double(s.e_perp.g * s.wi.y));
  }
  EXPECT_NEAR(e.mean(), truth, 0.02 * truth);
  EXPECT_LT(std::sqrt(e.variance()), 1.5 * truth) << "by power alone it would be more than 5 times";
}

TEST(LightSampler, DensityIsThatOfTheHit) {
  Scene scene;
  test::set_matt(test::add(scene, test::quad({-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1})), Rgb(0), Rgb(3));
  test::set_matt(test::add(scene, test::bumpy_ball(8), test::translation({3, 1, 0})), Rgb(0), Rgb(2));
  test::set_matt(
      test::add(scene, Cone{0.5f, 0.2f, 1}, test::translation({-3, 0, 0}) * Mat4(Mat3(1, 0, 0, 0, 2, 0, 0, 0, 1))),
      Rgb(0), Rgb(2));
  const LightSampler lights(scene);
  const auto accelerator = build_accelerator(scene);
  const Point3 x(0.2f, 0.3f, 2);
  int compared = 0;
  for (uint32_t i = 0; i < 500; ++i) {
    const ArrivingLight s = lights.sample(x, van_der_corput_owen(i, 3), sobol_owen(i, 4));
    if (is_black(s.e_perp)) continue;
    const Hit hit = accelerator->intersect(Ray{x, s.wi});
    if (!hit || std::abs(hit.distance - length(s.target - x)) > 1e-3f) continue;  // something is in between
    const float cosine = std::abs(dot(normalize(hit.normal), s.wi));
    EXPECT_NEAR(lights.pdf(x, hit, hit.distance, cosine), s.pdf, 2e-2f * s.pdf);
    ++compared;
  }
  EXPECT_GT(compared, 200);
}

TEST(EnvironmentSampler, DensityIntegratesToOneAndFollowsThePicture) {
  EnvironmentLight sky;
  sky.radiance = Image(32, 16, 3, 0.01f);
  sky.radiance.set_rgb(20, 5, Rgb(100));
  sky.colour = Radiance(Rgb(2));
  sky.rotation = 1;
  const EnvironmentSampler sampler(sky);
  double sum = 0;
  int bright = 0;
  constexpr uint32_t kCount = 100000;
  for (uint32_t i = 0; i < kCount; ++i) {
    const Vec2 u = sobol_owen(i, 1);
    const float y = 1 - 2 * u.x, r = std::sqrt(1 - y * y), phi = float(2 * kPi) * u.y;
    sum += double(sampler.pdf({r * std::cos(phi), y, r * std::sin(phi)})) * 4 * kPi / kCount;
    const auto s = sampler.sample(u);
    EXPECT_NEAR(length(s.direction), 1, 1e-5);
    if (i % 100 == 0) {
      EXPECT_NEAR(sampler.pdf(s.direction), s.pdf, 0.02f * s.pdf + 1e-4f);
    }
    bright += radiance(sky, s.direction).v.g > 20;
  }
  EXPECT_NEAR(sum, 1, 0.01);
  EXPECT_GT(bright, int(kCount) / 2);
}

}  // namespace
}  // namespace aktina
