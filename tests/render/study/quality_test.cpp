// The measures of a study on pictures whose answers are known.
#include "aktina/render/study/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "render/study/scenes.h"

namespace aktina {
namespace {

Image picture(int width, int height, const std::function<float(int x, int y)>& value) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.set_rgb(x, y, Rgb(value(x, y)));
  return image;
}

TEST(StudyQuality, RmseAndLargestErrorOfExposedValues) {
  const Image reference = picture(20, 10, [](int, int) { return 2.0f; });
  const Image other = picture(20, 10, [](int x, int) { return x < 5 ? 3.0f : 2.0f; });
  const Quality q = compare_pictures(other, reference, 0.25f);
  EXPECT_NEAR(q.rmse, 0.25 * std::sqrt(0.25), 1e-6);
  EXPECT_NEAR(q.max_error, 0.25, 1e-6);
  EXPECT_NEAR(q.psnr, -20 * std::log10(0.125), 1e-4);
  EXPECT_GT(q.flip, 0);
  EXPECT_EQ(compare_pictures(reference, reference, 1).rmse, 0);
}

TEST(StudyQuality, ValuesThatAreNoNumbersAreCounted) {
  Image broken = picture(4, 4, [](int, int) { return 0.5f; });
  broken.pixels[3] = NAN, broken.pixels[7] = INFINITY;
  const Quality q = compare_pictures(broken, picture(4, 4, [](int, int) { return 0.5f; }), 1);
  EXPECT_EQ(q.not_finite, 2u);
  EXPECT_TRUE(std::isfinite(q.rmse));
}

TEST(StudyQuality, HighlightsAreWhatLampsAddToAMattPicture) {
  const Image matt = picture(10, 10, [](int, int) { return 0.3f; });
  const Image shiny = picture(10, 10, [](int x, int) { return x < 2 ? 0.8f : 0.32f; });
  const Image mask = highlight_mask(shiny, matt, 1);
  EXPECT_EQ(mask.pixels[1], 1);
  EXPECT_EQ(mask.pixels[2], 0) << "below a twentieth of white";
  EXPECT_NEAR(masked_rmse(matt, shiny, mask, 1), 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(masked_rmse(matt, matt, highlight_mask(matt, matt, 1), 1))) << "no highlight, no number";
}

/// Two triangles that share the edge x = 0, seen from straight ahead.
Scene two_triangles(float lean) {
  Mesh mesh;
  mesh.positions = {{0, -1, 0}, {0, 1, 0}, {-2, 0, 0}, {0, -1, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(6, {0, 0, 1});
  for (size_t i = 3; i < 6; ++i) mesh.normals[i] = normalize(Vec3(lean, 0, 1));
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  Scene scene = test::shiny(std::move(mesh));
  scene.materials[0].double_sided = true;
  scene.cameras[0].kind = Camera::Kind::orthographic;
  scene.cameras[0].half_height = 2;
  return scene;
}

Quality edges_of(const std::function<float(int x, int y)>& value, float lean = 0) {
  const Scene scene = two_triangles(lean);
  const SmoothEdges edges(scene, scene.cameras[0], 64, 64);
  Quality q;
  edges.measure(picture(64, 64, value), 1, q);
  return q;
}

TEST(StudyQuality, ASmoothPictureHasNeitherJumpNorBand) {
  const Quality q = edges_of([](int x, int) { return 0.1f + 0.01f * float(x) + 2e-4f * float(x * x); });
  EXPECT_NEAR(q.edge_jump, 0, 1e-5);
  EXPECT_NEAR(q.mach_band, 0, 1e-5);
}

TEST(StudyQuality, AStepAtAnEdgeIsAJump) {
  const Quality q = edges_of([](int x, int) { return x < 32 ? 0.2f : 0.5f; });
  EXPECT_NEAR(q.edge_jump, 0.3, 1e-5);
  EXPECT_NEAR(q.mach_band, 0, 1e-5);
}

TEST(StudyQuality, AKinkAtAnEdgeIsABand) {
  const Quality q = edges_of([](int x, int) { return 0.2f + 0.02f * std::abs(float(x) - 31.5f); });
  EXPECT_NEAR(q.edge_jump, 0, 1e-5);
  EXPECT_NEAR(q.mach_band, 0.04, 1e-5);
}

TEST(StudyQuality, CreasesAreNoSmoothEdges) {
  EXPECT_TRUE(std::isnan(edges_of([](int x, int) { return x < 32 ? 0.2f : 0.5f; }, 0.5f).edge_jump));
}

TEST(StudyQuality, ATurnKeepsTheDistance) {
  const Camera camera = look_at({1, 2, 4}, {0.5f, 0, 0}, {0, 1, 0}, 0.6f);
  const Point3 centre(0.5f, 0, 0);
  const Camera other = turned(camera, centre, 0.3f);
  EXPECT_NEAR(length(other.position() - centre), length(camera.position() - centre), 1e-5);
  EXPECT_NEAR(other.position().y, 2, 1e-5) << "about the vertical";
  EXPECT_NEAR(dot(other.forward(), normalize(centre - other.position())), 1, 1e-5) << "still looks at it";
}

TEST(StudyQuality, FlickerIsTheChangeOfTheErrorNotTheError) {
  const auto flat = [](float value) { return picture(8, 8, [value](int, int) { return value; }); };
  const std::vector<Image> right = {flat(0.2f), flat(0.3f), flat(0.4f)};
  const std::vector<Image> steady = {flat(0.3f), flat(0.4f), flat(0.5f)};
  const std::vector<Image> shaking = {flat(0.3f), flat(0.2f), flat(0.5f)};
  EXPECT_NEAR(flicker(steady, right, 1), 0, 1e-6);
  EXPECT_NEAR(flicker(shaking, right, 1), 0.2, 1e-6);
}

}  // namespace
}  // namespace aktina
