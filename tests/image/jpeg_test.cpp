#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/made_files.h"
#include "image/pictures.h"

namespace aktina {
namespace {

using test::decode_error;
using test::made_jpeg;

std::vector<uint8_t> uniform(std::initializer_list<uint8_t> pixel, int count) {
  std::vector<uint8_t> codes;
  for (int i = 0; i < count; ++i) codes.insert(codes.end(), pixel);
  return codes;
}

TEST(Jpeg, ColourAndGrey) {
  const Image colour = decode_image(made_jpeg(16, 8, uniform({200, 100, 50}, 128)), "test");
  EXPECT_EQ(colour.channels, 3);
  const Rgb c = colour.rgb(5, 5);
  EXPECT_NEAR(linear_to_srgb(c.r) * 255, 200, 2);
  EXPECT_NEAR(linear_to_srgb(c.g) * 255, 100, 2);
  EXPECT_NEAR(linear_to_srgb(c.b) * 255, 50, 2);

  const std::vector<uint8_t> grey = made_jpeg(9, 5, uniform({77}, 45), TJPF_GRAY, TJFLAG_PROGRESSIVE);
  EXPECT_EQ(decode_image(grey, "test").channels, 1);
  EXPECT_NEAR(linear_to_srgb(decode_image(grey, "test").pixels[7]) * 255, 77, 1);
  const Bitmap texture = std::get<Bitmap>(decode_texture(grey, "test"));
  EXPECT_EQ(texture.channels, 4);
  EXPECT_EQ(texture.pixels[0], texture.pixels[2]);
  EXPECT_EQ(texture.pixels[3], 255);
}

/// Adobe's programs store 255 minus the ink.
TEST(Jpeg, InvertedCmyk) {
  const std::vector<uint8_t> bytes = made_jpeg(8, 8, uniform({255, 128, 0, 128}, 64), TJPF_CMYK);
  const std::vector<uint8_t> codes = std::get<Bitmap>(decode_texture(bytes, "test")).pixels;
  EXPECT_NEAR(codes[0], 128, 2);
  EXPECT_NEAR(codes[1], 64, 2);
  EXPECT_NEAR(codes[2], 0, 2);
  EXPECT_EQ(codes[3], 255);
}

TEST(Jpeg, BytesBetweenSegmentsAreHarmlessMissingOnesAreNot) {
  const std::vector<uint8_t> good = made_jpeg(32, 32, test::codes(32 * 32 * 3));
  std::vector<uint8_t> padded = good;
  padded.insert(padded.begin() + 20, {1, 2, 3});  // after the JFIF segment
  EXPECT_EQ(decode_image(padded, "test").pixels, decode_image(good, "test").pixels);
  EXPECT_EQ(decode_error(std::span(good).first(good.size() / 2)), Code::bad_input);
  EXPECT_EQ(decode_error(std::span(good).first(good.size() - 2)), Code::bad_input) << "no end of image";
}

TEST(Jpeg, RefusesClaimsBeforeItTakesMemory) {
  std::vector<uint8_t> bytes = made_jpeg(8, 8, test::codes(192));
  const uint8_t marker[] = {0xff, 0xc0};
  const auto frame = std::search(bytes.begin(), bytes.end(), marker, marker + 2);
  ASSERT_LT(frame + 9, bytes.end());
  for (int i = 5; i < 9; ++i) frame[i] = 0xea;  // 60138 x 60138
  EXPECT_EQ(decode_error(bytes), Code::limit);
  frame[5] = frame[7] = 0x3a;  // 15082 x 15082 would be allowed, were there data for them
  EXPECT_EQ(decode_error(bytes), Code::limit);
}

}  // namespace
}  // namespace aktina
