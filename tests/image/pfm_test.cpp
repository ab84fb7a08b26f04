#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image/pictures.h"

namespace aktina {
namespace {

using test::bytes_of;
using test::decode_error;

std::string floats(std::initializer_list<float> values) {
  std::string bytes(values.size() * 4, '\0');
  std::memcpy(bytes.data(), values.begin(), bytes.size());
  return bytes;
}

TEST(Pfm, KeepsFloats) {
  for (const int channels : {1, 3}) {
    const Image image = test::noise(5, 3, channels, 1e6f);
    const Image back = decode_image(test::written(image, "pfm"), "test");
    EXPECT_EQ(back.pixels, image.pixels);
    EXPECT_EQ(back.channels, channels);
  }
}

TEST(Pfm, AlphaIsDropped) {
  const Image back = decode_image(test::written(test::noise(2, 2, 4), "pfm"), "test");
  EXPECT_EQ(back.channels, 3);
}

TEST(Pfm, LowestRowFirstAndBothByteOrders) {
  EXPECT_THAT(decode_image(bytes_of("Pf\n1 2\n-1\n" + floats({1, 2})), "test").pixels, testing::ElementsAre(2, 1));
  std::string swapped = floats({3});
  std::reverse(swapped.begin(), swapped.end());
  EXPECT_THAT(decode_image(bytes_of("Pf 1 1 1.0 " + swapped), "test").pixels, testing::ElementsAre(3));
}

TEST(Pfm, Broken) {
  EXPECT_EQ(decode_error(bytes_of("PF\n2 2\n-1\n" + floats({1}))), Code::bad_input);
  EXPECT_EQ(decode_error(bytes_of("PF\n2")), Code::bad_input);
  EXPECT_EQ(decode_error(bytes_of("PF\n-2 2\n-1\n")), Code::bad_input);
  EXPECT_EQ(decode_error(bytes_of("PF\n0 2\n-1\n")), Code::bad_input);
  EXPECT_EQ(decode_error(bytes_of("PF\n60000 60000\n-1\n")), Code::limit);
  EXPECT_EQ(decode_error(bytes_of("PF\n99999999999 1\n-1\n")), Code::bad_input);
}

}  // namespace
}  // namespace aktina
