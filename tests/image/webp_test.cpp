#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/made_files.h"
#include "image/pictures.h"

namespace aktina {
namespace {

using test::decode_error;
using test::made_webp;

TEST(Webp, LosslessIsExact) {
  std::vector<uint8_t> rgba = test::codes(7 * 5 * 4);
  for (size_t i = 3; i < rgba.size(); i += 4) rgba[i] = uint8_t(rgba[i] | 1);  // colours below alpha 0 are not kept
  const std::vector<uint8_t> bytes = made_webp(7, 5, rgba);
  EXPECT_EQ(std::get<Bitmap>(decode_texture(bytes, "test")).pixels, rgba);
  const Image image = decode_image(bytes, "test");
  ASSERT_EQ(image.channels, 4);
  for (size_t i = 0; i < rgba.size(); ++i)
    EXPECT_FLOAT_EQ(image.pixels[i], i % 4 == 3 ? float(rgba[i]) / 255 : srgb_table()[rgba[i]]);
}

TEST(Webp, OpaqueAndLossy) {
  const std::vector<uint8_t> grey(16 * 16 * 4, 255);
  const Image image = decode_image(made_webp(16, 16, grey, false), "test");
  EXPECT_EQ(image.channels, 3);
  EXPECT_NEAR(image.pixels[100], 1, 0.02);
}

TEST(Webp, Broken) {
  const std::vector<uint8_t> good = made_webp(32, 32, test::codes(32 * 32 * 4));
  EXPECT_EQ(decode_error(std::span(good).first(good.size() / 2)), Code::bad_input);
  EXPECT_EQ(decode_error(std::span(good).first(14)), Code::bad_input);
  std::vector<uint8_t> animated = test::bytes_of("RIFF....WEBPVP8X....");
  animated.resize(60);
  const uint8_t sizes[] = {52, 0, 0, 0};
  std::copy(sizes, sizes + 4, animated.begin() + 4);
  animated[16] = 10, animated[17] = animated[18] = animated[19] = 0, animated[20] = 2;  // the flag of an animation
  EXPECT_EQ(decode_error(animated), Code::unsupported);
}

}  // namespace
}  // namespace aktina
