#include "aktina/export/lit_gltf.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "export/gltf_reader.h"
#include "export/lit_scene.h"
#include "test_files.h"

namespace aktina {
namespace {

using test::GltfFile;
using test::lit_square;

Scene original_of(const Scene& lit) {
  Scene original = lit;
  original.materials[0].unlit = false;
  original.meshes[0].colours.clear();
  return original;
}

GltfFile written(const Scene& lit, float exposure, const std::string& name = "lit.glb") {
  const test::TemporaryFolder folder;
  write_lit_gltf(folder / name, original_of(lit), lit, exposure, {{"Settings", "bake room.glb"}});
  return GltfFile(folder / name);
}

std::vector<double> colours(const GltfFile& file) {
  return file.values(file.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"]);
}

TEST(LitGltf, ColoursAreExposedRadianceAndNeverExceedOne) {
  const Scene lit = lit_square({Rgb(1, 2, 3), Rgb(0), Rgb(10), Rgb(0.5f)});
  for (const char* const name : {"lit.glb", "lit.gltf"}) {
    const GltfFile file = written(lit, 0.25f, name);
    EXPECT_EQ(colours(file), (std::vector<double>{0.25, 0.5, 0.75, 0, 0, 0, 1, 1, 1, 0.125, 0.125, 0.125}));
  }
}

TEST(LitGltf, RecordsExposureAndProvenance) {
  const GltfFile file = written(lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)}), 0.25f);
  EXPECT_EQ(file.json["asset"]["extras"]["aktina"]["exposure"], 0.25);
  EXPECT_EQ(file.json["asset"]["extras"]["aktina"]["Settings"], "bake room.glb");
}

TEST(LitGltf, GeometryIsWhatItWas) {
  const Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  const GltfFile file = written(lit, 1);
  const auto& primitive = file.json["meshes"][0]["primitives"][0];
  EXPECT_EQ(file.values(primitive["attributes"]["POSITION"]),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(file.values(primitive["attributes"]["TEXCOORD_0"]), (std::vector<double>{0, 1, 1, 1, 1, 0, 0, 0}));
  EXPECT_EQ(file.values(primitive["indices"]), (std::vector<double>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(file.json["accessors"][primitive["attributes"]["POSITION"].get<size_t>()]["max"],
            (std::vector<double>{1, 1, 0}));
}

TEST(LitGltf, UnlitMaterialsKeepBaseAlphaAndSidesAndNameTheirOriginal) {
  Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  Material& m = lit.materials[0];
  lit.images.push_back({"planks", "", "", {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 5}, Bitmap{}});
  m.base_texture = {.image = 0, .uv_set = 0, .scale = Vec2(2, 3), .wrap_u = Wrap::mirror};
  m.base_colour = Rgb(0.5f, 0.25f, 1);
  m.alpha = 0.75f, m.alpha_mode = AlphaMode::mask, m.alpha_cutoff = 0.25f, m.double_sided = true;
  m.roughness = 0.5f;
  m.original = R"({"extras": {"keep": "me"}, "extensions": {"VENDOR_plain": {"x": 1},
                  "VENDOR_textured": {"t": {"index": 4}}}})";
  const GltfFile file = written(lit, 1);
  const auto& materials = file.json["materials"];
  ASSERT_EQ(materials.size(), 2u);
  const auto& unlit = materials[0];
  EXPECT_TRUE(unlit["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(unlit["pbrMetallicRoughness"]["baseColorFactor"], (std::vector<double>{0.5, 0.25, 1, 0.75}));
  EXPECT_EQ(unlit["alphaMode"], "MASK");
  EXPECT_EQ(unlit["alphaCutoff"], 0.25);
  EXPECT_EQ(unlit["doubleSided"], true);
  ASSERT_EQ(unlit["extras"]["aktina"]["original"], 1);
  const auto& whole = materials[1];
  EXPECT_EQ(whole["name"], "paint");
  EXPECT_EQ(whole["pbrMetallicRoughness"]["roughnessFactor"], 0.5);
  EXPECT_EQ(whole["extras"]["keep"], "me");
  EXPECT_TRUE(whole["extensions"].contains("VENDOR_plain"));
  EXPECT_FALSE(whole["extensions"].contains("VENDOR_textured")) << "its texture would be another one here";
  EXPECT_EQ(whole["pbrMetallicRoughness"]["baseColorTexture"], unlit["pbrMetallicRoughness"]["baseColorTexture"]);
  const auto& image = file.json["images"][0];
  EXPECT_EQ(file.json["images"].size(), 1u) << "shared by both materials";
  const auto at = long(file.json["bufferViews"][image["bufferView"].get<size_t>()]["byteOffset"]);
  EXPECT_EQ(image["mimeType"], "image/png");
  EXPECT_EQ(std::vector<uint8_t>(file.data.begin() + at, file.data.begin() + at + 9), lit.images[0].encoded);
}

TEST(LitGltf, PicturesThatGltfDoesNotKnowBecomePng) {
  Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  lit.images.push_back({"sky", "", "", {}, Bitmap{1, 1, 4, false, {255, 128, 0, 255}}});
  lit.materials[0].base_texture = {.image = 0};
  const GltfFile file = written(lit, 1);
  const auto& view = file.json["bufferViews"][file.json["images"][0]["bufferView"].get<size_t>()];
  const auto at = file.data.begin() + long(view["byteOffset"]);
  const auto pixels = std::get<Bitmap>(decode_texture({at, at + long(view["byteLength"])}, "sky")).pixels;
  EXPECT_EQ(pixels, (std::vector<uint8_t>{255, 128, 0, 255}));
}

TEST(LitGltf, EmissionBeyondOneGoesIntoItsExtension) {
  Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  lit.materials[0].emission = Radiance(Rgb(50, 100, 200));
  const auto lamp = written(lit, 1).json["materials"][1];
  EXPECT_EQ(lamp["emissiveFactor"], (std::vector<double>{0.25, 0.5, 1}));
  EXPECT_EQ(lamp["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 200);
}

TEST(LitGltf, HierarchyNamesCamerasAndLightsStay) {
  Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  Mat4 up(1);
  up[3] = Vec4(0, 2, 0, 1);
  lit.nodes = {{"house", -1, up, up}, {"wall", 0, Mat4(1), up}, {"lamp", 0, Mat4(1), up}};
  lit.instances[0].node = 1, lit.instances[0].to_world = up;
  lit.lights.push_back({"bulb", SpotLight{.position = {0, 2, 0}, .intensity = Intensity(Rgb(30, 60, 15))}, 2});
  lit.cameras.push_back(look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.5f));
  lit.cameras[0].name = "view";
  const auto json = written(lit, 1).json;
  ASSERT_EQ(json["nodes"].size(), 4u);
  EXPECT_EQ(json["nodes"][0]["name"], "house");
  EXPECT_EQ(json["nodes"][0]["children"], (std::vector<int>{1, 2}));
  EXPECT_EQ(json["nodes"][0]["matrix"][13], 2);
  EXPECT_EQ(json["nodes"][1]["mesh"], 0);
  EXPECT_EQ(json["nodes"][2]["extensions"]["KHR_lights_punctual"]["light"], 0);
  EXPECT_EQ(json["nodes"][3]["camera"], 0);
  EXPECT_EQ(json["scenes"][0]["nodes"], (std::vector<int>{0, 3}));
  const auto& light = json["extensions"]["KHR_lights_punctual"]["lights"][0];
  EXPECT_EQ(light["intensity"], 60);
  EXPECT_EQ(light["color"], (std::vector<double>{0.5, 1, 0.25}));
  for (const float angle : {0.4f, 2.0f}) {  // a hard cone, which glTF does not know
    lit.lights[0].light = SpotLight{.inner_angle = angle, .outer_angle = angle};
    const auto hard = written(lit, 1).json["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"];
    EXPECT_LT(hard["innerConeAngle"].get<float>(), hard["outerConeAngle"].get<float>());
    EXPECT_LE(hard["outerConeAngle"].get<float>(), float(kPi / 2));
  }
}

TEST(LitGltf, ShearGoesIntoTheVertices) {
  Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  Mat4 shear(1);
  shear[1][0] = 1;  // x += y
  lit.nodes[0].local = lit.nodes[0].to_world = lit.instances[0].to_world = shear;
  const GltfFile file = written(lit, 1);
  for (const auto& node : file.json["nodes"]) EXPECT_FALSE(node.contains("matrix"));
  EXPECT_EQ(file.values(file.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"]),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 2, 1, 0, 1, 1, 0}));
}

TEST(LitGltf, BufferFileOfAnyNameIsFound) {
  const test::TemporaryFolder folder;
  const Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  write_lit_gltf(folder / "a b#ü.gltf", lit, lit, 1, {});
  EXPECT_EQ(nlohmann::json::parse(read_file(folder / "a b#ü.gltf"))["buffers"][0]["uri"], "a%20b%23%C3%BC.bin");
  EXPECT_TRUE(std::filesystem::exists(folder / "a b#ü.bin"));
}

TEST(LitGltf, AnUnwritableFolderLeavesNothing) {
  const test::TemporaryFolder folder;
  const Scene lit = lit_square({Rgb(1), Rgb(1), Rgb(1), Rgb(1)});
  EXPECT_THROW(write_lit_gltf(folder / "missing/lit.gltf", lit, lit, 1, {}), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(LitExposure, ClipsOnePercentOfTheArea) {
  std::vector<float> lux(1000, 100);
  for (size_t i = 0; i < 10; ++i) lux[i] = 1000 + 100 * float(i);  // 1 % of the area: may clip
  EXPECT_FLOAT_EQ(lit_exposure(test::row_of_patches(lux)), float(kPi / 100));
  lux[10] = 500;
  EXPECT_FLOAT_EQ(lit_exposure(test::row_of_patches(lux)), float(kPi / 500));
}

TEST(LitExposure, LampsMayClipAndDarknessHasNone) {
  Solution solution = test::row_of_patches({1e6f, 10});
  solution.mesh.emissions[0] = Radiosity(Rgb(1));
  EXPECT_FLOAT_EQ(lit_exposure(solution), float(kPi / 10));
  EXPECT_EQ(lit_exposure(test::row_of_patches({0, 0})), 1);
  EXPECT_EQ(lit_exposure({}), 1);
}

}  // namespace
}  // namespace aktina
