// Primitives, accessors and attributes.
#include <gtest/gtest.h>

#include <limits>

#include "aktina/import/gltf/meshes.h"
#include "gltf_file.h"

namespace aktina {
namespace {

using test::GltfFile;
using test::warned;
using Triangle = std::array<uint32_t, 3>;

constexpr int kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125;

TEST(GltfTriangles, ListsStripsAndFansKeepTheirWinding) {
  const std::vector<uint32_t> v = {0, 1, 2, 3, 4};
  EXPECT_EQ(gltf::triangulate(v, 4), (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(gltf::triangulate(v, 5), (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
  EXPECT_EQ(gltf::triangulate(v, 6), (std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
  EXPECT_TRUE(gltf::triangulate({0, 1}, 5).empty());
}

// A square as a strip: both halves face +z.
TEST(GltfTriangles, StripOfASquareFacesOneWay) {
  GltfFile file;
  file.attribute("POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 3);
  file.primitive()["mode"] = 5;
  const Scene scene = file.read();
  const Mesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  for (const auto& t : mesh.triangles) EXPECT_EQ(triangle_cross(mesh, t), Vec3(0, 0, 1));
  for (const Vec3 n : mesh.normals) EXPECT_EQ(n, Vec3(0, 0, 1)) << "flat normals where the file has none";
}

TEST(GltfTriangles, PointsAndLinesAreCountedAndLeftOut) {
  GltfFile file;
  file.triangle();
  file.primitive()["mode"] = 1;
  const Scene scene = file.read();
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_EQ(warned(scene, "points or lines"), 1u);
}

TEST(GltfTriangles, OnlyTheVerticesInUseAreKept) {
  GltfFile file;
  file.attribute("POSITION", {9, 9, 9, 0, 0, 0, 8, 8, 8, 1, 0, 0, 0, 1, 0, 7, 7, 7}, 3);
  file.primitive()["indices"] = file.accessor<uint16_t>({1, 3, 4}, "SCALAR", kU16, 1);
  const Scene scene = file.read();
  EXPECT_EQ(scene.meshes.at(0).positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(scene.meshes.at(0).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(GltfTriangles, UnusableOnesAreDroppedAndCounted) {
  GltfFile file;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  file.attribute("POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0, 2, 0, 0}, 3);
  file.primitive()["indices"] =
      file.accessor<uint32_t>({0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 99, 0, 0xffffffff, 2}, "SCALAR", kU32, 1);
  const Scene scene = file.read();
  EXPECT_EQ(triangle_count(scene), 1u);
  EXPECT_EQ(warned(scene, "not finite or beyond"), 1u);
  EXPECT_EQ(warned(scene, "without area"), 1u);
  EXPECT_EQ(warned(scene, "out of range were dropped"), 2u);
}

TEST(GltfAccessors, IntegersAreNormalizedAsTheSpecificationMapsThem) {
  GltfFile file;
  file.triangle();
  const auto add = [&](const char* name, int accessor) {
    file.primitive()["attributes"][name] = accessor;
    file.json["accessors"].back()["normalized"] = true;
  };
  add("TEXCOORD_0", file.accessor<uint8_t>({0, 255, 51, 0, 0, 0}, "VEC2", kU8, 2));
  add("TEXCOORD_1", file.accessor<int16_t>({-32768, 32767, 0, 0, 0, 0}, "VEC2", kI16, 2));
  add("COLOR_0", file.accessor<uint16_t>({65535, 0, 13107, 0, 0, 0, 0, 0, 0}, "VEC3", kU16, 3));
  const Scene scene = file.read();
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.uv[0].at(0), Vec2(0, 1));
  EXPECT_FLOAT_EQ(mesh.uv[0].at(1).x, 0.2f);
  EXPECT_EQ(mesh.uv[1].at(0), Vec2(-1, 1)) << "-32768 is -1 as well";
  EXPECT_EQ(mesh.colours.at(0), Vec4(1, 0, 0.2f, 1)) << "without alpha it is 1";
}

TEST(GltfAccessors, QuantizedPositionsAreWholeNumbers) {
  GltfFile file;
  file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  file.primitive()["attributes"]["POSITION"] =
      file.accessor<int8_t>({-128, 0, 0, 0, 127, 0, 0, 0, 5, 1, 0, 0}, "VEC3", kI8, 4);
  file.json["bufferViews"].back()["byteStride"] = 4;  // padded to 4 bytes
  const Scene scene = file.read();
  EXPECT_EQ(scene.meshes.at(0).positions, (std::vector<Point3>{{-128, 0, 0}, {127, 0, 0}, {5, 1, 0}}));
}

TEST(GltfAccessors, SparseValuesReplaceOthers) {
  GltfFile file;
  file.triangle();
  file.json["accessors"][0]["sparse"] = {{"count", 1},
                                         {"indices", {{"bufferView", file.view<uint8_t>({1})}, {"componentType", kU8}}},
                                         {"values", {{"bufferView", file.view<float>({5, 0, 0})}}}};
  EXPECT_EQ(file.read().meshes.at(0).positions.at(1), Point3(5, 0, 0));
  file.json["accessors"][0]["sparse"]["count"] = 4;
  EXPECT_NE(file.fault().find("/accessors/0/sparse/count"), std::string::npos);
}

TEST(GltfAccessors, InterleavedOnesHaveAStride) {
  GltfFile file;
  const int view = file.view<float>({0, 0, 0, 0.5f, 0.25f, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  file.json["bufferViews"][size_t(view)]["byteStride"] = 20;
  for (const char* type : {"VEC3", "VEC2"})
    file.json["accessors"].push_back({{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", type}});
  file.json["accessors"][1]["byteOffset"] = 12;
  file.primitive()["attributes"] = {{"POSITION", 0}, {"TEXCOORD_0", 1}};
  const Scene scene = file.read();
  EXPECT_EQ(scene.meshes.at(0).positions.at(2), Point3(0, 1, 0));
  EXPECT_EQ(scene.meshes.at(0).uv[0].at(0), Vec2(0.5f, 0.25f));
  EXPECT_EQ(scene.meshes.at(0).uv[0].at(2), Vec2(0, 1));
}

// u grows along +x; v grows along +y, downwards in the picture: the bitangent n x t w points to -y, so w is -1.
TEST(GltfAttributes, TangentsFollowTheTextureWhereANormalMapNeedsThem) {
  GltfFile file;
  file.triangle();
  file.attribute("TEXCOORD_0", {0, 0, 1, 0, 0, 1}, 2);
  file.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  file.json["textures"] = {{{"source", 0}}};
  file.json["images"] = {{{"uri", "missing.png"}}};
  EXPECT_TRUE(file.read().meshes.at(0).tangents.empty()) << "without a material";
  file.primitive()["material"] = 0;
  const Scene scene = file.read();
  EXPECT_EQ(scene.meshes.at(0).tangents, std::vector<Vec4>(3, Vec4(1, 0, 0, -1)));
}

TEST(GltfAttributes, NormalsAreMadeUnit) {
  GltfFile file;
  file.triangle();
  file.attribute("NORMAL", {0, 0, 2, 0, 0, 0, 0, 3, 0}, 3);
  const Scene scene = file.read();
  EXPECT_EQ(scene.meshes.at(0).normals, (std::vector<Vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
  EXPECT_EQ(warned(scene, "not of unit length"), 2u);
  EXPECT_EQ(warned(scene, "zero or not finite"), 1u);
}

TEST(GltfAttributes, MustBeAsLongAsPositions) {
  GltfFile file;
  file.triangle();
  file.attribute("NORMAL", {0, 0, 1}, 3);
  EXPECT_NE(file.fault().find("/meshes/0/primitives/0/attributes/NORMAL"), std::string::npos);
}

}  // namespace
}  // namespace aktina
