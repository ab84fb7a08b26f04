// What crosses from the reading process: the same on both sides, and not trusted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "aktina/base/error.h"
#include "aktina/import/assimp/document.h"

namespace aktina::assimp {
namespace {

constexpr uint64_t kPlenty = uint64_t(1) << 24;  // bytes

Document sample() {
  Document d;
  d.generator = "test";
  d.metres_per_unit = 0.01;
  d.nodes = {{"root", -1, Mat4(1)}, {"child", 0, Mat4(2)}};
  d.materials.emplace_back().name = "red";
  d.materials[0].diffuse.file = "a.png";
  FileMesh& mesh = d.meshes.emplace_back();
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.uv[1] = {{0, 0}, {1, 0}, {0, 1}};
  mesh.sizes = {3}, mesh.corners = {0, 1, 2}, mesh.material = 0;
  d.uses = {{1, 0}};
  d.lights.emplace_back().node = 1;
  d.cameras.emplace_back().node = 0;
  d.pictures.push_back({"b.png", {1, 2, 3}});
  d.warnings.push_back({"odd", 3});
  return d;
}

std::vector<uint8_t> sent(Document document) {
  std::vector<uint8_t> bytes;
  write(document, [&](std::span<const uint8_t> more) { bytes.insert(bytes.end(), more.begin(), more.end()); });
  return bytes;
}

Document received(std::span<const uint8_t> bytes, uint64_t most_bytes = kPlenty) {
  size_t at = 0;
  const Source source = [&](std::span<uint8_t> out) {
    if (out.size() > bytes.size() - at) throw Error(Code::io, "", "cut off");
    std::copy_n(bytes.begin() + long(at), out.size(), out.begin());
    at += out.size();
  };
  return read(source, most_bytes, "file");
}

TEST(AssimpDocument, ArrivesAsItWasSent) {
  const Document d = received(sent(sample()));
  EXPECT_EQ(d.nodes.at(1).name, "child");
  EXPECT_EQ(d.nodes.at(1).local, Mat4(2));
  EXPECT_EQ(d.materials.at(0).diffuse.file, "a.png");
  EXPECT_EQ(d.meshes.at(0).uv[1].at(1), Vec2(1, 0));
  EXPECT_EQ(d.pictures.at(0).bytes.size(), 3u);
  EXPECT_EQ(d.warnings.at(0).count, 3u);
  EXPECT_EQ(sent(d), sent(sample()));
}

TEST(AssimpDocument, CutOffAnywhereIsAnError) {
  const std::vector<uint8_t> all = sent(sample());
  for (size_t size = 0; size < all.size(); ++size) EXPECT_THROW(received(std::span(all).first(size)), Error) << size;
}

TEST(AssimpDocument, CountsBeyondTheLimitTakeNoMemory) {
  for (size_t at = 0; at + 8 <= sent(sample()).size(); ++at) {
    std::vector<uint8_t> bytes = sent(sample());
    std::memset(bytes.data() + at, 0x7f, 8);
    try {
      received(bytes);
    } catch (const Error&) {  // the other right answer: it was a number that may be anything
    }
  }
  EXPECT_THROW(received(sent(sample()), 100), Error);
}

TEST(AssimpDocument, IndicesAreChecked) {
  const auto refused = [](const auto& change) {
    Document d = sample();
    change(d);
    EXPECT_THROW(received(sent(d)), Error);
  };
  refused([](Document& d) { d.nodes[1].parent = 1; });
  refused([](Document& d) { d.nodes[0].parent = -2; });
  refused([](Document& d) { d.uses[0].mesh = 1; });
  refused([](Document& d) { d.uses[0].node = -1; });
  refused([](Document& d) { d.meshes[0].material = 1; });
  refused([](Document& d) { d.meshes[0].corners[2] = 3; });
  refused([](Document& d) { d.meshes[0].sizes[0] = 4; });
  refused([](Document& d) { d.meshes[0].sizes = {2, 1}; });
  refused([](Document& d) { d.meshes[0].normals.resize(2); });
  refused([](Document& d) { d.lights[0].node = 2; });
  refused([](Document& d) { d.cameras[0].node = 2; });
  refused([](Document& d) { d.metres_per_unit = 0; });
}

}  // namespace
}  // namespace aktina::assimp
