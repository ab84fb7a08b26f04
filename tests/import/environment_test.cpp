#include "aktina/import/environment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "aktina/import/import.h"
#include "gltf/gltf_file.h"
#include "test_files.h"

namespace aktina {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// 8 x 4, dark but for one place.
Image dark_sky(Rgb spot) {
  Image image(8, 4, 3, 0.25f);
  image.set_rgb(5, 1, spot);
  return image;
}

TEST(Environment, ShinesInPlaceOfTheScenesOwnLight) {
  const test::TemporaryFolder folder;
  write_image(folder / "sky.exr", dark_sky({4, 8, 16}));
  write_file(folder / "a.obj", std::string_view("v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"));
  ImportOptions options;
  options.environment = folder / "sky.exr", options.environment_scale = 10, options.environment_rotation = 1;
  const Scene scene = load_scene(folder / "a.obj", options);
  EXPECT_TRUE(scene.lights.empty()) << "no default light";
  EXPECT_EQ(scene.environment.radiance.rgb(5, 1), Rgb(4, 8, 16));
  EXPECT_EQ(scene.environment.colour.v, Rgb(10));
  EXPECT_EQ(scene.environment.rotation, 1);
  EXPECT_NE(hash(scene).text(), hash(load_scene(folder / "a.obj")).text());
  options.environment = folder / "none.exr";
  EXPECT_THROW(load_scene(folder / "a.obj", options), Error);
}

TEST(Environment, ValuesThatAreNoLightBecomeZero) {
  const test::TemporaryFolder folder;
  Image image = dark_sky({1, kNaN, -3});
  image.set_rgb(0, 0, {std::numeric_limits<float>::infinity(), 1, 1});
  write_image(folder / "sky.exr", image);
  Warnings warnings;
  const EnvironmentLight light = environment_of(read_file(folder / "sky.exr"), "sky.exr", Rgb(1), 0, warnings);
  EXPECT_EQ(light.radiance.rgb(5, 1), Rgb(1, 0, 0));
  EXPECT_EQ(light.radiance.rgb(0, 0), Rgb(0, 1, 1));
  ASSERT_EQ(warnings.items().size(), 1U);
  EXPECT_EQ(warnings.items()[0].count, 3U);
}

TEST(Environment, ABlackOneAndWhatIsNoPictureAreRefused) {
  const test::TemporaryFolder folder;
  write_image(folder / "sky.exr", Image(4, 2, 3));
  Warnings warnings;
  EXPECT_THROW(environment_of(read_file(folder / "sky.exr"), "sky.exr", Rgb(1), 0, warnings), Error);
  const std::vector<uint8_t> text = {'t', 'e', 'x', 't'};
  EXPECT_THROW(environment_of(text, "text", Rgb(1), 0, warnings), Error);
}

TEST(Environment, InTheExtrasOfAGltfFile) {
  test::GltfFile file;
  file.triangle();
  file.json["extras"]["aktina"]["environment"] = {{"scale", {1, 2, 3}}};
  EXPECT_EQ(file.read().environment.colour.v, Rgb(1, 2, 3)) << "even light where there is no picture";
  // A PNG of one white pixel.
  file.json["extras"]["aktina"]["environment"] = {
      {"uri",
       "data:image/png;base64,"
       "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg=="},
      {"rotation", 0.5}};
  const Scene scene = file.read();
  EXPECT_EQ(scene.environment.radiance.rgb(0, 0), Rgb(1));
  EXPECT_EQ(scene.environment.rotation, 0.5f);
  file.json["extras"]["aktina"]["environment"]["uri"] = "../sky.hdr";
  EXPECT_NE(file.fault(), "") << "outside of the folder";
  file.json["extras"]["aktina"]["environment"] = {{"scale", {1, -2, 3}}};
  EXPECT_NE(file.fault(), "");
}

}  // namespace
}  // namespace aktina
