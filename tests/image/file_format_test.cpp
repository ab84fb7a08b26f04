// What holds for every image format: found by its bytes, written whole or not at all, and broken files are refused.
#include "aktina/image/file_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "image/made_files.h"
#include "image/pictures.h"

namespace aktina {
namespace {

struct Sample {
  std::string name;
  ImageFormat format;
  std::vector<uint8_t> bytes;
};

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = {
      {"png", ImageFormat::png, test::written(test::noise(19, 11, 4), "png")},
      {"exr", ImageFormat::exr, test::written(test::noise(19, 11, 4), "exr")},
      {"hdr", ImageFormat::hdr, test::written(test::noise(19, 11, 3), "hdr")},
      {"pfm", ImageFormat::pfm, test::written(test::noise(19, 11, 3), "pfm")},
      {"jpeg", ImageFormat::jpeg, test::made_jpeg(19, 11, test::codes(19 * 11 * 3))},
      {"progressive jpeg", ImageFormat::jpeg,
       test::made_jpeg(19, 11, test::codes(19 * 11 * 3), TJPF_RGB, TJFLAG_PROGRESSIVE)},
      {"webp", ImageFormat::webp, test::made_webp(19, 11, test::codes(19 * 11 * 4))},
      {"lossy webp", ImageFormat::webp, test::made_webp(19, 11, test::codes(19 * 11 * 4), false)},
  };
  return all;
}

TEST(FileFormat, IsFoundByTheBytesNotTheName) {
  const test::TemporaryFolder folder;
  for (const Sample& sample : samples()) {
    EXPECT_EQ(detect_image_format(sample.bytes), sample.format) << sample.name;
    const ImageHeader header = read_image_header(sample.bytes, "test");
    EXPECT_EQ(header.format, sample.format) << sample.name;
    EXPECT_EQ(header.width, 19) << sample.name;
    EXPECT_EQ(header.height, 11) << sample.name;
    write_file(folder / "picture.txt", sample.bytes);
    const Image image = read_image(folder / "picture.txt");
    EXPECT_EQ(image.channels, header.channels) << sample.name;
    EXPECT_EQ(read_layered_image(folder / "picture.txt").layers[0].image.pixels, image.pixels) << sample.name;
    const bool bitmap = std::holds_alternative<Bitmap>(decode_texture(sample.bytes, "test"));
    EXPECT_EQ(bitmap, header.bits == 8 && sample.name != "hdr") << sample.name;
  }
}

TEST(FileFormat, WhatIsNoImageIsRefused) {
  EXPECT_EQ(detect_image_format({}), ImageFormat::unknown);
  EXPECT_EQ(test::decode_error({}), Code::bad_input);
  EXPECT_EQ(test::decode_error(test::bytes_of("solid cube")), Code::bad_input);
  EXPECT_THROW(read_image("/no/such/file.png"), Error);
}

TEST(FileFormat, WritingChoosesByTheExtension) {
  const test::TemporaryFolder folder;
  write_image(folder / "PICTURE.PNG", test::noise(2, 2, 3));
  EXPECT_EQ(detect_image_format(read_file(folder / "PICTURE.PNG")), ImageFormat::png);
  for (const char* name : {"picture.jpeg", "picture.tif", "picture"}) {
    EXPECT_THROW(write_image(folder / name, test::noise(2, 2, 3)), Error) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
  EXPECT_THROW(write_image(folder / "a.png", Image()), Error);
  EXPECT_THROW(write_image(folder / "a.png", Image(2, 2, 5)), Error);
  LayeredImage uneven;
  uneven.add("", 2, 2, 3), uneven.add("Z", 3, 2, 1);
  EXPECT_THROW(write_image(folder / "a.exr", uneven), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

/// Decodes by every way there is: success and aktina::Error are both right, anything else fails the test.
void try_all(std::span<const uint8_t> bytes) {
  const auto attempt = [](auto read) {
    try {
      read();
    } catch (const Error&) {
      return;
    }
  };
  attempt([&] { read_image_header(bytes, "test"); });
  attempt([&] { decode_image(bytes, "test"); });
  attempt([&] { decode_texture(bytes, "test"); });
}

TEST(BrokenImages, TruncatedAnywhere) {
  for (const Sample& sample : samples()) {
    for (size_t size = 0; size < sample.bytes.size(); size += 1 + size / 40)
      try_all(std::span(sample.bytes).first(size));
    EXPECT_EQ(test::decode_error(std::span(sample.bytes).first(sample.bytes.size() * 3 / 4)), Code::bad_input)
        << sample.name;
  }
}

TEST(BrokenImages, FlippedBits) {
  uint32_t state = 7;
  const auto next = [&](size_t n) { return (state = state * 1664525u + 1013904223u, size_t(state >> 8) % n); };
  for (const Sample& sample : samples()) {
    for (int round = 0; round < 400; ++round) {
      std::vector<uint8_t> bytes = sample.bytes;
      const size_t reach =
          round % 2 ? bytes.size() : std::min<size_t>(bytes.size(), 300);  // half of them in the header
      for (size_t flips = 1 + next(4); flips-- > 0;) bytes[next(reach)] ^= uint8_t(1u << next(8));
      try_all(bytes);
    }
  }
}

/// Real damaged files from other projects' regression suites.
TEST(BrokenImages, ThirdPartyFiles) {
  AKTINA_NEEDS_THIRD_PARTY_SCENES();
  int files = 0;
  for (const char* folder : {"img-fuzz-corpus", "img-oiio-bad", "img-pngsuite", "exr-openexr-images",
                             "exr-openexr-tests", "exr-tinyexr-crashers", "scene-radiance", "hdr-polyhaven"}) {
    const std::filesystem::path path = test::third_party_scenes() / folder;
    if (!std::filesystem::exists(path)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (!entry.is_regular_file()) continue;
      try_all(read_file(entry.path()));
      ++files;
    }
  }
  EXPECT_GT(files, 0);
#if !defined(__SANITIZE_THREAD__)  // it takes several times the memory itself
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  EXPECT_LT(use.ru_maxrss, 1 << 20) << "kB";
#endif
}

}  // namespace
}  // namespace aktina
