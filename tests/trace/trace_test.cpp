#include "aktina/trace/trace.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "trace/integrator/light_scenes.h"

namespace aktina {
namespace {

using test::options;

Scene small_room() {
  Scene scene;
  test::set_matt(test::add(scene, test::room({-1, 0, -1}, {1, 2, 1})), {0.7f, 0.6f, 0.5f});
  test::set_matt(test::add(scene, test::quad({-0.3f, 1.99f, -0.3f}, {0.3f, 1.99f, -0.3f}, {0.3f, 1.99f, 0.3f},
                                             {-0.3f, 1.99f, 0.3f})),
                 Rgb(0), Rgb(10));
  test::set_metal(test::add(scene, Sphere{0.4f}, test::translation({0.3f, 0.4f, 0})), Rgb(0.9f), 0.2f);
  test::set_glass(test::add(scene, Sphere{0.3f}, test::translation({-0.5f, 0.3f, 0.3f})), 1.5f);
  scene.lights.push_back({"", PointLight{{0.5f, 1.5f, 0.5f}, Intensity(Rgb(1)), {}}, -1});
  return scene;
}
const Camera kCamera = look_at({0, 1, 0.95f}, {0, 0.6f, -1}, {0, 1, 0}, 1.2f);

TEST(Trace, SamePictureForAnyNumberOfThreads) {
  const Scene scene = small_room();
  for (const char* method : {"path", "direct", "whitted"}) {
    TraceOptions o = options(method, 5);
    o.direct = o.indirect = o.illuminance = o.albedo = o.normal = true;
    set_thread_count(1);
    const LayeredImage one = trace(scene, kCamera, 67, 45, o);
    set_thread_count(4);
    const LayeredImage four = trace(scene, kCamera, 67, 45, o);
    set_thread_count(0);
    ASSERT_EQ(one.layers.size(), 6U);
    for (size_t i = 0; i < one.layers.size(); ++i)
      EXPECT_EQ(one.layers[i].image.pixels, four.layers[i].image.pixels) << method << " " << one.layers[i].name;
  }
}

TEST(Trace, SeedsGiveDifferentPicturesOfTheSameScene) {
  const Scene scene = small_room();
  const LayeredImage a = trace(scene, kCamera, 32, 32, options("path", 64, 1));
  const LayeredImage b = trace(scene, kCamera, 32, 32, options("path", 64, 2));
  EXPECT_NE(a.layers[0].image.pixels, b.layers[0].image.pixels);
  double mean_a = 0, mean_b = 0;
  for (const float x : a.layers[0].image.pixels) mean_a += double(x);
  for (const float x : b.layers[0].image.pixels) mean_b += double(x);
  EXPECT_NEAR(mean_a, mean_b, 0.02 * mean_a);
}

TEST(Trace, DirectAndIndirectMakeThePicture) {
  TraceOptions o = options("path", 4);
  o.direct = o.indirect = true;
  const LayeredImage picture = trace(small_room(), kCamera, 16, 16, o);
  const Image &all = picture.layers[0].image, &direct = *picture.find("direct"), &indirect = *picture.find("indirect");
  double sum = 0;
  for (size_t i = 0; i < all.pixels.size(); ++i) {
    EXPECT_NEAR(all.pixels[i], direct.pixels[i] + indirect.pixels[i], 1e-5f * all.pixels[i]);
    sum += double(indirect.pixels[i]);
  }
  EXPECT_GT(sum, 0);
}

TEST(Trace, LayersOfGeometry) {
  Scene scene;
  test::set_matt(test::add(scene, Sphere{1}), {0.2f, 0.4f, 0.6f});
  TraceOptions o = options("whitted", 1);
  o.albedo = o.normal = o.position = o.depth = true;
  const LayeredImage picture = trace(scene, look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.8f), 31, 31, o);
  EXPECT_NEAR(picture.find("Z")->at(15, 15)[0], 4, 1e-5);
  EXPECT_NEAR(picture.find("N")->at(15, 15)[2], 1, 1e-5);
  EXPECT_NEAR(picture.find("P")->at(15, 15)[2], 1, 1e-5);
  EXPECT_NEAR(picture.find("albedo")->at(15, 15)[1], 0.4f, 1e-6);
  EXPECT_EQ(picture.find("Z")->at(0, 0)[0], kInfinity);
  EXPECT_EQ(picture.find("N")->at(0, 0)[2], 0);
}

TEST(Trace, IlluminanceOfTheFloorInAClosedBox) {
  // Matt walls of reflectance rho that shine with L in a closed box: E = pi L / (1 - rho) everywhere.
  Scene scene;
  test::set_matt(test::add(scene, test::room(Point3(-1), Point3(1))), Rgb(0.5f), Rgb(1));
  TraceOptions o = options("path", 256);
  o.illuminance = true;
  const LayeredImage picture = trace(scene, look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0.8f), 4, 4, o);
  for (const float e : picture.find("illuminance")->pixels) EXPECT_NEAR(e, 2 * kPi, 0.4);
}

TEST(Trace, PassesAreShownAsTheyAreDone) {
  TraceOptions o = options("path", 20);
  std::vector<int> seen;
  o.each_pass = [&](const LayeredImage& picture, int samples) {
    EXPECT_EQ(picture.layers[0].image.width, 16);
    seen.push_back(samples);
  };
  TraceStatistics statistics;
  trace(small_room(), kCamera, 16, 16, o, nullptr, &statistics);
  EXPECT_EQ(seen, (std::vector<int>{1, 2, 4, 8, 16, 20}));
  EXPECT_EQ(statistics.samples, 20);
  EXPECT_GE(statistics.rays, 20U * 16 * 16);
}

TEST(Trace, CancelledWorkLeavesWholePasses) {
  TraceOptions o = options("path", 1000);
  Progress progress;
  o.each_pass = [&](const LayeredImage&, int samples) {
    if (samples == 4) progress.cancel();
  };
  TraceStatistics statistics;
  const LayeredImage partial = trace(small_room(), kCamera, 16, 16, o, &progress, &statistics);
  EXPECT_EQ(statistics.samples, 4);
  const LayeredImage whole = trace(small_room(), kCamera, 16, 16, options("path", 4));
  EXPECT_EQ(partial.layers[0].image.pixels, whole.layers[0].image.pixels);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(trace(small_room(), kCamera, 16, 16, o, &cancelled), Error);
}

TEST(Trace, RefusesWhatCannotBe) {
  const Scene scene = small_room();
  EXPECT_THROW(trace(scene, kCamera, 0, 16), Error);
  EXPECT_THROW(trace(scene, kCamera, 1 << 16, 1 << 16), Error);
  EXPECT_THROW(trace(scene, kCamera, 8, 8, options("path", 0)), Error);
  EXPECT_THROW(trace(scene, kCamera, 8, 8, options("paths", 1)), Error);
  EXPECT_THROW(trace(scene, kCamera, 8, 8, options("path:depth=-1", 1)), Error);
  TraceOptions o;
  o.accelerator = "octree-of-doom";
  EXPECT_THROW(trace(scene, kCamera, 8, 8, o), Error);
}

}  // namespace
}  // namespace aktina
