// OpenEXR: our own files come back exactly; files of every kind that others make, made here by the library itself.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "aktina/image/exr_stream.h"
#include "image/pictures.h"

namespace aktina {
namespace {

using Imath::Box2i;
using Imath::V2i;
using test::decode_error;
using testing::ElementsAre;

LayeredImage layered() {
  LayeredImage picture;
  picture.layers.push_back({"", test::noise(13, 7, 3, 1e5f, 1)});
  picture.layers.push_back({"N", test::noise(13, 7, 3, 1, 2)});
  picture.layers.push_back({"Z", test::noise(13, 7, 1, 10, 3)});
  picture.layers.push_back({"illuminance", test::noise(13, 7, 1, 500, 4)});
  picture.layers.push_back({"albedo", test::noise(13, 7, 3, 1, 5)});
  return picture;
}

TEST(OpenExr, LayersComeBackExactly) {
  const LayeredImage picture = layered();
  const test::TemporaryFolder folder;
  write_image(folder / "picture.exr", picture);
  const LayeredImage back = read_layered_image(folder / "picture.exr");
  ASSERT_EQ(back.layers.size(), picture.layers.size());
  EXPECT_EQ(back.layers[0].name, "");
  for (const LayeredImage::Layer& layer : picture.layers) {
    ASSERT_TRUE(back.find(layer.name)) << layer.name;
    EXPECT_EQ(back.find(layer.name)->pixels, layer.image.pixels) << layer.name;
  }
  EXPECT_EQ(read_image(folder / "picture.exr").pixels, picture.layers[0].image.pixels);
  EXPECT_THAT(read_image_header(read_file(folder / "picture.exr"), "test").layers,
              ElementsAre("", "N", "albedo", "illuminance", "Z"));
}

TEST(OpenExr, MetadataAreAttributes) {
  ImageWriteOptions options;
  options.metadata = {{"software", "aktina"}, {"compression", "none of its business"}};
  const std::vector<uint8_t> bytes = test::written(test::noise(2, 2, 3), "exr", options);
  ExrInput in(bytes);
  const Imf::InputFile file(in);
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("software").value(), "aktina");
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("metadata.compression").value(), "none of its business");
}

TEST(OpenExr, TwoLayersOfOneNameAreRefused) {
  LayeredImage picture = layered();
  picture.layers[2].name = "N", picture.layers[2].image = picture.layers[1].image;
  EXPECT_THROW(test::written(picture, "exr"), Error);
}

/// One channel "Y" of 20 x 10 pixels with value x + 100 y in the data window.
struct Made {
  Imf::Compression compression = Imf::NO_COMPRESSION;
  Imf::PixelType type = Imf::HALF;
  Box2i data{V2i(0, 0), V2i(19, 9)}, display{V2i(0, 0), V2i(19, 9)};
  bool tiled = false, levels = false;

  std::vector<uint8_t> bytes() const {
    Imf::Header header(display, data);
    header.compression() = compression;
    header.channels().insert("Y", Imf::Channel(type));
    const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
    std::vector<half> halves;
    std::vector<uint32_t> wholes;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        halves.push_back(half(float(x + 100 * y))), wholes.push_back(uint32_t(x + 100 * y));
    void* const values = type == Imf::HALF ? static_cast<void*>(halves.data()) : wholes.data();
    const size_t size = type == Imf::HALF ? 2 : 4;
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice::Make(type, values, data, size, size * size_t(width)));
    ExrOutput out;
    if (tiled) {
      header.setTileDescription({7, 3, levels ? Imf::MIPMAP_LEVELS : Imf::ONE_LEVEL});
      Imf::TiledOutputFile file(out, header);
      for (int level = 0; level < file.numLevels(); ++level) {
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
      }
    } else {
      Imf::OutputFile file(out, header);
      file.setFrameBuffer(frame);
      file.writePixels(height);
    }
    return out.take();
  }
};

void expect_ramp(const Made& made, float tolerance = 0) {
  const Image image = decode_image(made.bytes(), "test");
  ASSERT_EQ(image.width, 20);
  ASSERT_EQ(image.height, 10);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) ASSERT_NEAR(*image.at(x, y), float(x + 100 * y), tolerance) << x << " " << y;
}

TEST(OpenExr, EveryCompression) {
  for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression) {
    SCOPED_TRACE(compression);
    Made made;
    made.compression = Imf::Compression(compression);
    expect_ramp(made, compression >= Imf::B44_COMPRESSION ? 60.0f : 0.0f);  // those lose something
  }
}

TEST(OpenExr, TilesLevelsAndWholeNumbers) {
  Made made;
  made.tiled = true;
  expect_ramp(made);
  made.levels = true;
  expect_ramp(made);
  made = {};
  made.type = Imf::UINT;
  expect_ramp(made);
}

TEST(OpenExr, DataArePlacedInTheDisplayWindow) {
  Made made;
  made.data = {V2i(-2, 3), V2i(4, 11)};
  made.display = {V2i(0, 0), V2i(9, 5)};
  const Image image = decode_image(made.bytes(), "test");
  ASSERT_EQ(image.width, 10);
  ASSERT_EQ(image.height, 6);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 10; ++x)
      EXPECT_EQ(*image.at(x, y), x <= 4 && y >= 3 ? float(x + 2 + 100 * (y - 3)) : 0) << x << " " << y;
  made.data = {V2i(100, 100), V2i(104, 104)};  // nothing of it is seen
  EXPECT_EQ(decode_image(made.bytes(), "test").pixels, std::vector<float>(60, 0));
}

std::vector<uint8_t> made_rgba(const std::vector<Imf::Rgba>& pixels, int width, Imf::RgbaChannels channels,
                               const Imf::Chromaticities& primaries = {}) {
  const int height = int(pixels.size()) / width;
  Imf::Header header(width, height);
  if (!(primaries == Imf::Chromaticities())) Imf::addChromaticities(header, primaries);
  ExrOutput out;
  {
    Imf::RgbaOutputFile file(out, header, channels);
    file.setFrameBuffer(pixels.data(), 1, size_t(width));
    file.writePixels(height);
  }
  return out.take();
}

TEST(OpenExr, LuminanceAndChroma) {
  std::vector<Imf::Rgba> pixels(16 * 16, Imf::Rgba(0.8f, 0.4f, 0.2f));
  const Image image = decode_image(made_rgba(pixels, 16, Imf::WRITE_YC), "test");
  ASSERT_EQ(image.channels, 3);
  for (int i = 0; i < 256; ++i) {
    const Rgb c = image.rgb(i % 16, i / 16);
    EXPECT_NEAR(c.r, 0.8f, 4e-3);
    EXPECT_NEAR(c.g, 0.4f, 4e-3);
    EXPECT_NEAR(c.b, 0.2f, 4e-3);
  }
}

TEST(OpenExr, OtherPrimariesBecomeRec709) {
  // The primaries of Rec. 2020; its green lies outside of Rec. 709, its white is the same.
  const Imf::Chromaticities wide({0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f});
  const Image image = decode_image(made_rgba({{1, 1, 1}, {0, 1, 0}}, 2, Imf::WRITE_RGB, wide), "test");
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.at(0, 0)[c], 1, 1e-3);
  // ITU-R BT.2087, the inverse of its matrix M2
  EXPECT_NEAR(image.at(1, 0)[0], -0.5876, 1e-3);
  EXPECT_NEAR(image.at(1, 0)[1], 1.1329, 1e-3);
  EXPECT_NEAR(image.at(1, 0)[2], -0.1006, 1e-3);
}

TEST(OpenExr, PartsAreLayers) {
  std::vector<Imf::Header> headers;
  for (const char* name : {"beauty", "depth"}) {
    Imf::Header header(4, 1);
    header.setName(name), header.setType(Imf::SCANLINEIMAGE);
    header.channels().insert(name == std::string("depth") ? "Z" : "Y", Imf::Channel(Imf::FLOAT));
    headers.push_back(header);
  }
  std::vector<float> values = {1, 2, 3, 4};
  ExrOutput out;
  {
    Imf::MultiPartOutputFile file(out, headers.data(), 2);
    for (int part = 0; part < 2; ++part) {
      Imf::FrameBuffer frame;
      frame.insert(part ? "Z" : "Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 16));
      Imf::OutputPart output(file, part);
      output.setFrameBuffer(frame), output.writePixels(1);
    }
  }
  const test::TemporaryFolder folder;
  write_file(folder / "parts.exr", out.take());
  const LayeredImage picture = read_layered_image(folder / "parts.exr");
  ASSERT_EQ(picture.layers.size(), 2u);
  EXPECT_EQ(picture.layers[0].name, "");
  EXPECT_EQ(picture.layers[1].name, "depth.Z");
  EXPECT_EQ(picture.layers[1].image.pixels, values);
}

TEST(OpenExr, RefusesClaimsBeforeItTakesMemory) {
  const std::vector<uint8_t> good = Made{}.bytes();
  const auto with_windows = [&](int32_t right, int32_t bottom) {
    std::vector<uint8_t> bytes = good;
    for (const char* name : {"dataWindow", "displayWindow"}) {
      const std::string key(name);
      const auto at = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
      const auto box = at + std::ptrdiff_t(key.size() + 1 + sizeof("box2i") + 4);
      std::memcpy(&box[8], &right, 4), std::memcpy(&box[12], &bottom, 4);
    }
    return bytes;
  };
  EXPECT_EQ(decode_image(with_windows(19, 9), "test").width, 20);
  for (const auto& [right, bottom] : {std::pair(59999, 59999), {16383, 16383}, {1 << 29, 9}, {19, 1 << 29}}) {
    const Code code = decode_error(with_windows(right, bottom));
    EXPECT_TRUE(code == Code::limit || code == Code::bad_input) << right << " x " << bottom;
  }
  EXPECT_EQ(decode_error(with_windows(-5, 9)), Code::bad_input);
}

/// The library takes memory for what an attribute claims, before it reads.
TEST(OpenExr, AnAttributeLargerThanTheFileIsRefused) {
  std::vector<uint8_t> bytes = Made{}.bytes();
  const std::string name = "pixelAspectRatio";
  const auto at = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
  const auto size = at + std::ptrdiff_t(name.size() + 1 + sizeof("float"));
  ASSERT_EQ(*size, 4);
  size[2] = 0x20, size[3] = 0x70;
  EXPECT_EQ(decode_error(bytes), Code::bad_input);
  EXPECT_EQ(decode_error(std::span(bytes).first(6)), Code::bad_input);
}

/// The library reads as much as the type says, and would take what follows for names and sizes.
TEST(OpenExr, AnAttributeOfAnotherSizeThanItsTypeIsRefused) {
  const std::vector<uint8_t> good = Made{}.bytes();
  for (const std::string type : {"chlist", "box2i", "float", "v2f", "lineOrder"}) {
    std::vector<uint8_t> bytes = good;
    const std::string key = std::string(1, '\0') + type + std::string(1, '\0');
    const auto at = std::search(bytes.begin(), bytes.end(), key.begin(), key.end());
    ASSERT_LT(at + std::ptrdiff_t(key.size()), bytes.end()) << type;
    const auto size = at + std::ptrdiff_t(key.size());
    ++*size;
    bytes.insert(size + 4 + (*size - 1), 0);  // one byte more
    EXPECT_EQ(decode_error(bytes), Code::bad_input) << type;
  }
}

/// What the library does not read safely from a broken file is refused before it sees it.
TEST(OpenExr, DeepPicturesAndManifestsAreRefused) {
  std::vector<uint8_t> deep = Made{}.bytes();
  deep[5] |= 0x08;
  EXPECT_EQ(decode_error(deep), Code::unsupported);
  std::vector<uint8_t> manifest = Made{}.bytes();
  const std::string attribute("ids\0idmanifest\0\4\0\0\0\0\0\0\0", 23);
  manifest.insert(manifest.begin() + 8, attribute.begin(), attribute.end());
  EXPECT_EQ(decode_error(manifest), Code::unsupported);
}

}  // namespace
}  // namespace aktina
