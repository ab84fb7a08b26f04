// PNG: what is written is what is read; what other writers make is read as the specification says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spng.h>

#include <memory>

#include "image/pictures.h"

namespace aktina {
namespace {

using test::decode_error;
using test::noise;
using test::written;

ImageWriteOptions plain(int bits = 8) {
  ImageWriteOptions options;
  options.tone_mapping.exposure = 1;
  options.png_bits = bits;
  return options;
}

/// A PNG of any kind from raw code values, made by libspng itself.
struct Made {
  uint8_t type, depth, interlace = 0;
  double gamma = 0;
  bool srgb = false, transparent = false;

  std::vector<uint8_t> from(uint32_t width, uint32_t height, std::vector<uint8_t> raw) const {
    const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> png(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
    spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_ihdr ihdr{width, height, depth, type, 0, 0, interlace};
    spng_set_ihdr(png.get(), &ihdr);
    if (gamma > 0) spng_set_gama(png.get(), gamma);
    if (srgb) spng_set_srgb(png.get(), 0);
    if (type == SPNG_COLOR_TYPE_INDEXED) {
      spng_plte palette{};
      palette.n_entries = 2;
      palette.entries[0] = {255, 0, 0, 255}, palette.entries[1] = {0, 0, 255, 255};
      spng_set_plte(png.get(), &palette);
    }
    if (transparent) {
      spng_trns trns{};
      trns.n_type3_entries = 1;
      trns.type3_alpha[0] = 51;
      spng_set_trns(png.get(), &trns);
    }
    EXPECT_EQ(spng_encode_image(png.get(), raw.data(), raw.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE), 0);
    size_t size = 0;
    int error = 0;
    void* const buffer = spng_get_png_buffer(png.get(), &size, &error);
    std::vector<uint8_t> bytes(static_cast<uint8_t*>(buffer), static_cast<uint8_t*>(buffer) + size);
    std::free(buffer);
    return bytes;
  }
};

TEST(Png, KeepsEveryChannelCountWithinHalfACode) {
  for (const int bits : {8, 16}) {
    for (const int channels : {1, 2, 3, 4}) {
      const Image image = noise(17, 9, channels);
      const std::vector<uint8_t> bytes = written(image, "png", plain(bits));
      const ImageHeader header = read_image_header(bytes, "test");
      EXPECT_EQ(header.channels, channels);
      EXPECT_EQ(header.bits, bits);
      const Image back = decode_image(bytes, "test");
      ASSERT_EQ(back.pixels.size(), image.pixels.size());
      const float half_code = bits == 8 ? 0.5f / 255 : 0.5f / 65535;
      for (size_t i = 0; i < image.pixels.size(); ++i) {
        const bool alpha = channels % 2 == 0 && i % size_t(channels) == size_t(channels) - 1;
        const float a = alpha ? image.pixels[i] : linear_to_srgb(image.pixels[i]);
        const float b = alpha ? back.pixels[i] : linear_to_srgb(back.pixels[i]);
        ASSERT_NEAR(a, b, half_code + 1e-6f) << channels << " channels, " << bits << " bits";
      }
    }
  }
}

TEST(Png, EveryCodeComesBack) {
  Image image(256, 1, 1);
  for (int i = 0; i < 256; ++i) *image.at(i, 0) = srgb_table()[size_t(i)];
  EXPECT_EQ(decode_image(written(image, "png", plain()), "test").pixels, image.pixels);
}

TEST(Png, ClipsWhatAScreenCannotShow) {
  Image image(4, 1, 1);
  image.pixels = {-1, 2, NAN, INFINITY};
  EXPECT_THAT(decode_image(written(image, "png", plain()), "test").pixels, testing::ElementsAre(0, 1, 0, 1));
}

TEST(Png, CarriesMetadataInAsciiAndUtf8) {
  ImageWriteOptions options = plain();
  options.metadata = {{"Software", "aktina 1"}, {"Szene", "Küche"}};
  const std::vector<uint8_t> bytes = written(noise(2, 2, 3), "png", options);
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> png(spng_ctx_new(0), &spng_ctx_free);
  spng_set_png_buffer(png.get(), bytes.data(), bytes.size());
  spng_text texts[2];
  uint32_t count = 2;
  ASSERT_EQ(spng_get_text(png.get(), texts, &count), 0);
  EXPECT_EQ(std::string(texts[0].keyword) + "=" + texts[0].text, "Software=aktina 1");
  EXPECT_EQ(texts[0].type, SPNG_TEXT);
  EXPECT_EQ(std::string(texts[1].keyword) + "=" + texts[1].text, "Szene=Küche");
  EXPECT_EQ(texts[1].type, SPNG_ITXT);
}

TEST(Png, PalettesAndTransparency) {
  const std::vector<uint8_t> bytes =
      Made{.type = SPNG_COLOR_TYPE_INDEXED, .depth = 1, .transparent = true}.from(2, 1, {0x40});
  EXPECT_THAT(decode_image(bytes, "test").pixels, testing::ElementsAre(1, 0, 0, 0.2f, 0, 0, 1, 1));
  EXPECT_THAT(std::get<Bitmap>(decode_texture(bytes, "test")).pixels,
              testing::ElementsAre(255, 0, 0, 51, 0, 0, 255, 255));
}

TEST(Png, InterlacedIsTheSamePicture) {
  std::vector<uint8_t> raw(13 * 11 * 3);
  for (size_t i = 0; i < raw.size(); ++i) raw[i] = uint8_t(i * 37);
  const Made straight{.type = SPNG_COLOR_TYPE_TRUECOLOR, .depth = 8};
  Made adam7 = straight;
  adam7.interlace = 1;
  EXPECT_EQ(decode_image(straight.from(13, 11, raw), "test").pixels,
            decode_image(adam7.from(13, 11, raw), "test").pixels);
}

TEST(Png, GammaChunkIsObeyedUnlessTheFileSaysSrgb) {
  const std::vector<uint8_t> raw = {128};
  const Made grey{.type = SPNG_COLOR_TYPE_GRAYSCALE, .depth = 8};
  Made linear = grey, usual = grey, both = grey;
  linear.gamma = 1, usual.gamma = 0.45455, both.gamma = 1, both.srgb = true;
  const auto value = [&](const Made& made) { return decode_image(made.from(1, 1, raw), "test").pixels[0]; };
  EXPECT_FLOAT_EQ(value(linear), 128 / 255.0f);
  EXPECT_EQ(value(grey), srgb_table()[128]);
  EXPECT_EQ(value(usual), srgb_table()[128]);
  EXPECT_EQ(value(both), srgb_table()[128]);
  EXPECT_EQ(std::get<Bitmap>(decode_texture(linear.from(1, 1, raw), "test")).pixels[0], 128);
}

/// The bytes of an IHDR chunk with its right checksum, after the signature.
std::vector<uint8_t> claim(uint32_t width, uint32_t height) {
  std::vector<uint8_t> bytes = Made{.type = SPNG_COLOR_TYPE_GRAYSCALE, .depth = 8}.from(1, 1, {0});
  const auto put = [&](size_t at, uint32_t v) {
    for (size_t i = 0; i < 4; ++i) bytes[at + i] = uint8_t(v >> (24 - 8 * i));
  };
  put(16, width), put(20, height);
  uint32_t crc = 0xffffffffu;
  for (size_t i = 12; i < 29; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
  }
  put(29, ~crc);
  return bytes;
}

TEST(Png, RefusesClaimsBeforeItTakesMemory) {
  EXPECT_EQ(decode_error(claim(60000, 60000)), Code::limit);
  EXPECT_EQ(decode_error(claim(16384, 16384)), Code::limit) << "allowed, but not in 70 bytes";
  EXPECT_EQ(decode_error(claim(0x7fffffff, 0x7fffffff)), Code::limit);
  EXPECT_EQ(decode_error(claim(0, 5)), Code::bad_input);
  EXPECT_EQ(decode_error(claim(3, 3)), Code::bad_input) << "too few pixels";
}

}  // namespace
}  // namespace aktina
