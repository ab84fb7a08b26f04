// Two passes against path tracing and against what mirrors must show.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/solve.h"
#include "aktina/trace/trace.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

Scene lit_room() {
  Scene scene = room({2, 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  add_quad(scene, {0.7f, 1.99f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
  add_box(scene, {0.5f, 0.001f, 0.5f}, {0.5f, 0.8f, 0.5f}, Rgb(0.7f));
  return scene;
}
Camera view() { return look_at({1.9f, 1.2f, 1.9f}, {0.6f, 0.6f, 0.6f}, {0, 1, 0}, 1.2f); }

Rgb mean(const Image& image) {
  Rgb sum;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += image.rgb(x, y);
  return sum / float(image.width * image.height);
}

/// Mean over the pixels of |a - b|, over the mean of b.
double relative_difference(const Image& a, const Image& b) {
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) sum += std::abs(double(a.rgb(x, y).g) - double(b.rgb(x, y).g));
  return sum / (a.width * a.height) / double(mean(b).g);
}

TEST(TwoPass, AgreesWithPathTracingWhereAllIsDiffuse) {
  const Scene scene = lit_room();
  const Solution solution = solve_radiosity(scene, {.patch_size = 0.1, .tolerance = 1e-3});
  const LayeredImage two_pass = render_two_pass(scene, solution, view(), 32, 24, {.samples = 64});
  TraceOptions path;
  path.samples = 144;
  const LayeredImage traced = trace(scene, view(), 32, 24, path);
  const Image &a = two_pass.layers[0].image, &b = traced.layers[0].image;
  EXPECT_LT(relative_difference(a, b), 0.05);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean(a)[c], mean(b)[c], 0.02f * mean(b)[c]);
}

TEST(TwoPass, RadiosityAloneAgreesWithPathTracingToo) {
  const Scene scene = lit_room();
  const Solution solution = solve_radiosity(scene, {.patch_size = 0.1, .tolerance = 1e-3});
  const Image a = render_solution(scene, solution, view(), 32, 24).layers[0].image;
  TraceOptions path;
  path.samples = 144;
  const Image b = trace(scene, view(), 32, 24, path).layers[0].image;
  EXPECT_LT(relative_difference(a, b), 0.08);
  EXPECT_NEAR(mean(a).g, mean(b).g, 0.02f * mean(b).g);
}

TEST(TwoPass, FinalGatherFindsShadowsThatCoarsePatchesMiss) {
  const Scene scene = lit_room();
  const Solution coarse = solve_radiosity(scene, {.patch_size = 0.5, .tolerance = 1e-3});
  TraceOptions path;
  path.samples = 400;
  const Image traced = trace(scene, view(), 32, 24, path).layers[0].image;
  const auto drawn = [&](const char* method) {
    return render_two_pass(scene, coarse, view(), 32, 24, {.method = method, .samples = 256}).layers[0].image;
  };
  const double looked_up = relative_difference(drawn("two_pass"), traced);
  const Image gathered = drawn("two_pass:gather=1");
  EXPECT_LT(relative_difference(gathered, traced), 0.8 * looked_up);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean(gathered)[c], mean(traced)[c], 0.03f * mean(traced)[c]);
}

TEST(TwoPass, AMirrorShowsWhatIsInFrontOfIt) {
  Scene scene = room({2, 2, 2}, Rgb(0.5f));
  add_quad(scene, {0.7f, 1.99f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
  add_quad(scene, {0.5f, 0.5f, 0.01f}, {1, 0, 0}, {0, 1, 0}, Rgb(1));
  Material& mirror = scene.materials.back();
  mirror.metallic = 1, mirror.roughness = 0, mirror.specular_weight = 1;
  const Solution solution = solve_radiosity(scene, {.patch_size = 0.1});
  const Camera at_mirror = look_at({1, 1, 1}, {1, 1, 0}, {0, 1, 0}, 0.1f);
  const Rgb seen = mean(render_two_pass(scene, solution, at_mirror, 8, 8, {.samples = 16}).layers[0].image);
  TraceOptions path;
  path.samples = 144;
  const Rgb expected = mean(trace(scene, at_mirror, 8, 8, path).layers[0].image);
  EXPECT_GT(expected.g, 0.5f);
  EXPECT_NEAR(seen.g, expected.g, 0.1f * expected.g);
}

TEST(TwoPass, SameBytesForAnyNumberOfThreads) {
  const Scene scene = lit_room();
  const Solution solution = solve_radiosity(scene, {.patch_size = 0.3, .tolerance = 0.1});
  set_thread_count(1);
  const auto one = render_two_pass(scene, solution, view(), 32, 24, {.samples = 2}).layers[0].image.pixels;
  set_thread_count(2);
  const auto two = render_two_pass(scene, solution, view(), 32, 24, {.samples = 2}).layers[0].image.pixels;
  set_thread_count(0);
  EXPECT_EQ(one, two);
}

TEST(TwoPass, RefusesASolutionOfAnotherSceneAndBadOptions) {
  const Solution solution = solve_radiosity(lit_room(), {.patch_size = 1, .tolerance = 0.5});
  EXPECT_THAT(
      [&] {
        render_two_pass(room({1, 1, 1}, Rgb(0.5f)), solution, view(), 8, 8);
      },
      testing::ThrowsMessage<Error>(testing::HasSubstr("another scene")));
  EXPECT_THROW(render_two_pass(lit_room(), solution, view(), 8, 8, {.samples = 0}), Error);
  EXPECT_THROW(render_two_pass(lit_room(), solution, view(), 0, 8), Error);
}

}  // namespace
}  // namespace aktina
