#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "image/pictures.h"

namespace aktina {
namespace {

using test::bytes_of;
using test::decode_error;
using testing::ElementsAre;

/// A flat picture of white pixels whose exponents are given: values 2^(e - 129) / 2.
std::vector<uint8_t> flat(const std::string& resolution, const std::string& exponents,
                          const std::string& variables = "FORMAT=32-bit_rle_rgbe\n") {
  std::string text = "#?RADIANCE\n" + variables + "\n" + resolution + "\n";
  for (const char e : exponents) text += std::string("\x80\x80\x80", 3) + char(uint8_t(129 + e - '0'));
  return bytes_of(text);
}
std::vector<float> reds(const std::vector<uint8_t>& bytes) {
  const Image image = decode_image(bytes, "test");
  std::vector<float> values;
  for (size_t i = 0; i < image.pixels.size(); i += 3) values.push_back(image.pixels[i]);
  return values;
}

TEST(RadianceHdr, RoundTripIsWithinHalfAMantissa) {
  for (const int width : {1, 7, 8, 300}) {  // below 8 pixels a line has no run lengths
    const Image image = test::noise(width, 5, 3, 1000);
    const Image back = decode_image(test::written(image, "hdr"), "test");
    for (int y = 0; y < 5; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(image.at(x, y)[c], back.at(x, y)[c], max_channel(image.rgb(x, y)) * (1.0f / 256 + 1e-6f));
  }
}

TEST(RadianceHdr, RunsAreKept) {
  Image image(600, 2, 3, 0.25f);
  for (int x = 100; x < 105; ++x) image.set_rgb(x, 0, Rgb(float(x)));
  for (int x = 105; x < 108; ++x) image.set_rgb(x, 0, Rgb(2));  // too short for a run
  const std::vector<uint8_t> bytes = test::written(image, "hdr");
  EXPECT_EQ(decode_image(bytes, "test").pixels, image.pixels);
  EXPECT_LT(bytes.size(), 250u) << "packed";
}

RC_GTEST_PROP(RadianceHdr, AnyValueIsWrittenAsANumber, ()) {
  Image image(1, 1, 3);
  for (float& v : image.pixels) {
    const uint32_t bits = *rc::gen::arbitrary<uint32_t>();
    std::memcpy(&v, &bits, 4);
  }
  for (const float v : decode_image(test::written(image, "hdr"), "test").pixels) RC_ASSERT(std::isfinite(v) && v >= 0);
}

/// The slow axis comes first; +X runs to the right, +Y upwards.
TEST(RadianceHdr, AllOrientations) {
  EXPECT_THAT(reds(flat("-Y 2 +X 2", "0123")), ElementsAre(1, 2, 4, 8));
  EXPECT_THAT(reds(flat("-Y 2 -X 2", "0123")), ElementsAre(2, 1, 8, 4));
  EXPECT_THAT(reds(flat("+Y 2 +X 2", "0123")), ElementsAre(4, 8, 1, 2));
  EXPECT_THAT(reds(flat("+Y 2 -X 2", "0123")), ElementsAre(8, 4, 2, 1));
  EXPECT_THAT(reds(flat("+X 2 -Y 2", "0123")), ElementsAre(1, 4, 2, 8));
  EXPECT_THAT(reds(flat("+X 2 +Y 2", "0123")), ElementsAre(2, 8, 1, 4));
  EXPECT_THAT(reds(flat("-X 2 -Y 2", "0123")), ElementsAre(4, 1, 8, 2));
  EXPECT_THAT(reds(flat("-X 2 +Y 2", "0123")), ElementsAre(8, 2, 4, 1));
  EXPECT_THAT(reds(flat("+X 2 -Y 1", "01")), ElementsAre(1, 2));
}

TEST(RadianceHdr, OldRunLengths) {
  std::vector<uint8_t> bytes = flat("-Y 1 +X 1000", "3");
  for (const uint8_t count : {uint8_t(0xe7), uint8_t(3)}) bytes.insert(bytes.end(), {1, 1, 1, count});  // 0x3e7 = 999
  EXPECT_EQ(reds(bytes), std::vector<float>(1000, 8));
  bytes.back() = 4;  // one run too long
  EXPECT_EQ(decode_error(bytes), Code::bad_input);
  EXPECT_EQ(decode_error(bytes_of("#?RADIANCE\n\n-Y 1 +X 9\n\1\1\1\1")), Code::bad_input) << "nothing to repeat";
}

TEST(RadianceHdr, HeaderLines) {
  EXPECT_THAT(reds(flat("-Y 1 +X 1", "0", "")), ElementsAre(1)) << "without a FORMAT line";
  EXPECT_THAT(reds(flat("-Y 1 +X 1", "0", "EXPOSURE=2\nEXPOSURE= 4.0e0\n")), ElementsAre(0.125f));
  EXPECT_THAT(reds(flat("-Y 1 +X 1", "0", "EXPOSURE=0\nEXPOSURE=nan\n")), ElementsAre(1)) << "no exposures";
  EXPECT_THAT(decode_image(flat("-Y 1 +X 1", "0", "COLORCORR=2 4 0.5\n"), "test").pixels, ElementsAre(0.5f, 0.25f, 2));
  EXPECT_EQ(decode_error(flat("-Y 1 +X 1", "0", "FORMAT=ascii\n")), Code::unsupported);
  std::vector<uint8_t> old = bytes_of("pfilt -x 1\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n....");
  EXPECT_EQ(detect_image_format(old), ImageFormat::hdr);
}

TEST(RadianceHdr, XyzKeepsWhite) {
  for (const float v : decode_image(flat("-Y 1 +X 1", "0", "FORMAT=32-bit_rle_xyze\n"), "test").pixels)
    EXPECT_NEAR(v, 1, 1e-6);
}

TEST(RadianceHdr, Broken) {
  const std::vector<uint8_t> good = test::written(test::noise(20, 20, 3), "hdr");
  EXPECT_EQ(decode_error(std::span(good).first(good.size() - 1)), Code::bad_input);
  EXPECT_EQ(decode_error(flat("-Y 60000 +X 60000", "")), Code::limit);
  EXPECT_EQ(decode_error(flat("-Y 16000 +X 16000", "")), Code::limit) << "allowed, but not in a few bytes";
  for (const char* resolution : {"-Y 1 +Y 1", "-Y 1", "-Y -1 +X 1", "-Y 0 +X 1", "Y 1 X 1", "-Y 99999999999 +X 1", ""})
    EXPECT_EQ(decode_error(flat(resolution, "0")), Code::bad_input) << resolution;
  EXPECT_EQ(decode_error(bytes_of("#?RADIANCE\n")), Code::bad_input);
  EXPECT_EQ(decode_error(bytes_of(std::string("#?RADIANCE\n\n-Y 1 +X 8\n\2\2\0\x09", 26))), Code::bad_input)
      << "length";
  EXPECT_EQ(decode_error(bytes_of(std::string("#?RADIANCE\n\n-Y 1 +X 8\n\2\2\0\x08\0", 27))), Code::bad_input)
      << "no count";
}

}  // namespace
}  // namespace aktina
