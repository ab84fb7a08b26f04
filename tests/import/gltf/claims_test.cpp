// Small files that claim a lot, and files that repeat themselves: refused before memory or time is spent.
#include <gtest/gtest.h>

#include "gltf_file.h"

namespace aktina {
namespace {

using test::GltfFile;
using test::Json;
using test::warned;

TEST(GltfClaims, VerticesOutOfNothingAreRefused) {
  GltfFile file;
  file.json["accessors"] = {{{"componentType", 5126}, {"count", 4294967294U}, {"type", "VEC3"}}};
  file.primitive()["attributes"]["POSITION"] = 0;
  EXPECT_NE(file.fault().find("/meshes/0/primitives/0: would take"), std::string::npos);
}

TEST(GltfClaims, OneBufferUsedByManyIsCountedEachTime) {
  GltfFile file;
  file.attribute("POSITION", std::vector<float>(300000, 1.0f), 3);
  Json& primitives = file.json["meshes"][0]["primitives"];
  for (int i = 0; i < 2000; ++i) primitives.push_back(primitives[0]);
  EXPECT_NE(file.fault().find("of what a file of this size may take"), std::string::npos);
}

TEST(GltfClaims, MostBytesIsALimit) {
  GltfFile file;
  file.attribute("POSITION", std::vector<float>(30000, 1.0f), 3);
  ImportOptions options;
  options.most_bytes = 100000;
  try {
    read_gltf(file.bytes(), "/nowhere", "test.glb", options);
    FAIL() << "should be over the limit";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::limit);
  }
}

TEST(GltfClaims, OffsetsThatOverflowAreBeyondTheBuffer) {
  GltfFile file;
  file.triangle();
  for (const uint64_t offset : {uint64_t(9007199254740991), UINT64_MAX}) {
    file.json["bufferViews"][0]["byteOffset"] = offset;
    EXPECT_NE(file.fault().find("/bufferViews/0"), std::string::npos) << offset;
  }
}

TEST(GltfClaims, CompressedCountsAreCheckedFirst) {
  GltfFile file;
  file.triangle();
  file.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  file.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0}, {"byteLength", 36}, {"byteStride", 12}, {"count", 4000000000U}, {"mode", "ATTRIBUTES"}};
  EXPECT_NE(file.fault().find("/bufferViews/0/extensions/EXT_meshopt_compression"), std::string::npos);
}

// Each was once looked for through the whole document: minutes.
TEST(GltfClaims, ThousandsOfMissingPicturesTakeNoTime) {
  GltfFile file;
  for (int i = 0; i < 20000; ++i) file.json["images"].push_back({{"uri", "missing.png"}});
  const Scene scene = file.read();
  EXPECT_EQ(scene.images.size(), 20000u);
  EXPECT_GT(warned(scene, "taken as white"), 0u);
}

TEST(GltfClaims, LengthsOfAGlbAreChecked) {
  GltfFile file;
  file.triangle();
  const std::vector<uint8_t> whole = file.bytes();
  for (const size_t at : {size_t(8), size_t(12)}) {  // the file's length, the first chunk's
    std::vector<uint8_t> bytes = whole;
    bytes[at + 3] = 0xff;
    EXPECT_THROW(read_gltf(bytes, {}, "test.glb"), Error);
  }
  for (size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(read_gltf(std::span(whole).first(length), {}, "test.glb"), Error) << length;
}

}  // namespace
}  // namespace aktina
