#include "aktina/texture/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace aktina {
namespace {

/// 2 x 2: red, green / blue, white, opaque above and half transparent below.
TextureImage four_texels() {
  TextureImage image;
  image.pixels = Bitmap{2, 2, 4, false, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 128, 255, 255, 255, 128}};
  return image;
}

Texture nearest(Wrap wrap = Wrap::repeat) {
  Texture use;
  use.filter = Filter::nearest, use.wrap_u = use.wrap_v = wrap;
  return use;
}

TEST(Texture, TexelCentresAreExactAndVPointsDown) {
  const TextureImage image = four_texels();
  for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
    Texture use;
    use.filter = filter;
    EXPECT_EQ(look_up(image, use, {0.25f, 0.25f}, true), Vec4(1, 0, 0, 1));
    EXPECT_EQ(look_up(image, use, {0.75f, 0.25f}, true), Vec4(0, 1, 0, 1));
    EXPECT_EQ(look_up(image, use, {0.25f, 0.75f}, true), Vec4(0, 0, 1, 128 / 255.0f));
  }
}

TEST(Texture, FiltersLinearValues) {
  const TextureImage image = four_texels();
  const Vec4 middle = look_up(image, Texture{}, {0.5f, 0.25f}, true);
  EXPECT_EQ(middle, Vec4(0.5f, 0.5f, 0, 1)) << "half of the light of each, not half of the codes";
}

TEST(Texture, ColourIsDecodedDataIsNot) {
  TextureImage image;
  image.pixels = Bitmap{1, 1, 4, false, {128, 128, 128, 128}};
  const Vec4 colour = look_up(image, Texture{}, {0.5f, 0.5f}, true),
             data = look_up(image, Texture{}, {0.5f, 0.5f}, false);
  EXPECT_NEAR(colour.x, 0.2158605, 1e-6);
  EXPECT_NEAR(data.x, 128 / 255.0, 1e-7);
  EXPECT_EQ(colour.w, data.w) << "alpha is always linear";
}

TEST(Texture, Wraps) {
  const TextureImage image = four_texels();
  const Vec4 red(1, 0, 0, 1), green(0, 1, 0, 1);
  EXPECT_EQ(look_up(image, nearest(), {1.25f, 0.25f}, true), red);
  EXPECT_EQ(look_up(image, nearest(), {-0.25f, 0.25f}, true), green);
  EXPECT_EQ(look_up(image, nearest(Wrap::clamp), {5, 0.25f}, true), green);
  EXPECT_EQ(look_up(image, nearest(Wrap::clamp), {-5, 0.25f}, true), red);
  EXPECT_EQ(look_up(image, nearest(Wrap::mirror), {1.25f, 0.25f}, true), green);
  EXPECT_EQ(look_up(image, nearest(Wrap::mirror), {1.75f, 0.25f}, true), red);
  EXPECT_EQ(look_up(image, nearest(Wrap::mirror), {-0.25f, 0.25f}, true), red);
}

// KHR_texture_transform: a quarter turn counter-clockwise as seen takes the u axis to the direction of decreasing v.
TEST(Texture, Transforms) {
  const TextureImage image = four_texels();
  Texture use = nearest();
  use.rotation = float(kPi / 2);
  EXPECT_EQ(look_up(image, use, {0.25f, -0.75f}, true), look_up(image, nearest(), {-0.75f, -0.25f}, true));
  use = nearest();
  use.offset = {0.5f, 0}, use.scale = {0.5f, 1};
  EXPECT_EQ(look_up(image, use, {0.1f, 0.25f}, true), Vec4(0, 1, 0, 1));
}

TEST(Texture, AnyCoordinateIsSafe) {
  const TextureImage image = four_texels();
  const float large = std::numeric_limits<float>::max();
  for (const float u : {NAN, INFINITY, -INFINITY, large, -large, 1e9f, -1e-30f})
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp})
      for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
        Texture use = nearest(wrap);
        use.filter = filter;
        for (const Vec2 uv : {Vec2(u, 0.3f), Vec2(0.3f, u), Vec2(u, u)}) {
          const Vec4 v = look_up(image, use, uv, true);
          EXPECT_TRUE(v.x >= 0 && v.x <= 1) << u;
        }
      }
}

TEST(Texture, FloatAndGreyImages) {
  TextureImage image;
  Image pixels(1, 1, 1, 3.5f);
  image.pixels = pixels;
  EXPECT_EQ(look_up(image, Texture{}, {0.5f, 0.5f}, true), Vec4(3.5f, 3.5f, 3.5f, 1));
  image.pixels = Bitmap{1, 1, 2, true, {51, 102}};
  EXPECT_LT(glm::length(look_up(image, Texture{}, {0.5f, 0.5f}, true) - Vec4(0.2f, 0.2f, 0.2f, 0.4f)), 1e-6f);
}

}  // namespace
}  // namespace aktina
