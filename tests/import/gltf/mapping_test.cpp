// Nodes, materials, lights and what lies beside a document.
#include <gtest/gtest.h>

#include "gltf_file.h"
#include "test_files.h"

namespace aktina {
namespace {

using test::GltfFile;
using test::Json;
using test::warned;

TEST(GltfNodes, TransformationsMultiplyDownTheTree) {
  GltfFile file;
  file.triangle();
  const float s = 0.70710678f;  // a quarter turn about z
  file.json["nodes"] = {{{"translation", {1, 2, 3}}, {"rotation", {0, 0, s, s}}, {"children", {1}}},
                        {{"scale", {2, 2, 2}}, {"mesh", 0}}};
  const Scene scene = file.read();
  const Point3 p = transform_point(scene.instances.at(0).to_world, {1, 0, 0});
  EXPECT_NEAR(p.x, 1, 1e-6);
  EXPECT_NEAR(p.y, 4, 1e-6);
  EXPECT_NEAR(p.z, 3, 1e-6);
  EXPECT_EQ(scene.nodes.at(1).parent, 0);
}

TEST(GltfNodes, WhatIsScaledToNothingIsLeftOut) {
  GltfFile file;
  file.triangle();
  file.json["nodes"][0]["scale"] = {1, 0, 1};
  const Scene scene = file.read();
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_EQ(warned(scene, "scale to nothing"), 1u);
}

TEST(GltfNodes, InvisibleOnesAreLeftOutWithTheirChildren) {
  GltfFile file;
  file.triangle();
  file.json["extensionsUsed"] = {"KHR_node_visibility"};
  file.json["nodes"] = {{{"children", {1}}}, {{"mesh", 0}}};
  EXPECT_EQ(file.read().instances.size(), 1u);
  file.json["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
  EXPECT_TRUE(file.read().instances.empty());
}

TEST(GltfNodes, ANodeHasOneParent) {
  GltfFile file;
  file.triangle();
  file.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
  EXPECT_NE(file.fault().find("/nodes/1/children/0"), std::string::npos);
}

TEST(GltfNodes, WhatStandsStillIsSaid) {
  GltfFile file;
  file.triangle();
  file.json["meshes"].push_back(file.json["meshes"][0]);
  file.json["skins"] = {{{"joints", {0}}}};
  file.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"path", "scale"}, {"node", 0}}}}}},
                              {"samplers", {{{"input", 0}, {"output", 0}}}}}};
  const Scene scene = file.read();
  EXPECT_EQ(warned(scene, "animations are left out"), 1u);
  EXPECT_EQ(warned(scene, "skins are left out"), 1u);
  EXPECT_EQ(warned(scene, "no node of the scene shows"), 1u);
}

TEST(GltfExtras, MayBeAnything) {
  GltfFile file;
  file.triangle();
  for (const Json& extras : {Json(5), Json("text"), Json::array({1}), Json(nullptr), Json({{"other", 1}})}) {
    file.json["extras"] = file.json["nodes"][0]["extras"] = extras;
    file.json["materials"] = {{{"extras", extras}}};
    EXPECT_EQ(file.fault(), "") << extras;
  }
}

TEST(GltfExtras, LightsThatGltfCannotSay) {
  GltfFile file;
  file.triangle();
  Json& node = file.json["nodes"][0];
  node["translation"] = {1, 2, 3}, node["scale"] = {2, 2, 2};
  const auto light = [&](const Json& fields) -> Scene {
    node["extras"]["aktina"]["light"] = fields;
    return file.read();
  };
  const Scene warn = light({{"type", "warn"}, {"intensity", {1, 2, 3}}, {"exponent", 4}, {"flap_low", {0, -1, 0}}});
  const auto* lamp = std::get_if<WarnLight>(&warn.lights.at(0).light);
  ASSERT_TRUE(lamp);
  EXPECT_EQ(lamp->position, Vec3(1, 2, 3));
  EXPECT_EQ(lamp->direction, Vec3(0, 0, -1));
  EXPECT_EQ(lamp->exponent, 4);
  EXPECT_EQ(lamp->flap_low, Vec3(0, -1, 0));
  EXPECT_EQ(lamp->flap_high.x, WarnLight::kNoFlap);
  const Scene point = light({{"type", "point"}, {"attenuation", {1, 0.5, 0}}, {"clamp", true}});
  EXPECT_EQ(std::get<PointLight>(point.lights.at(0).light).attenuation, (Attenuation{1, 0.5f, 0, true}));
  const Scene spot = light({{"type", "spot"}, {"outer_angle", 0.4}, {"exponent", 8}});
  EXPECT_EQ(std::get<SpotLight>(spot.lights.at(0).light).inner_angle, 0.4f) << "a hard edge";

  const Scene panel = light({{"type", "rectangle"}, {"width", 0.5}, {"height", 0.25}, {"radiance", {7, 8, 9}}});
  EXPECT_TRUE(panel.lights.empty());
  ASSERT_EQ(panel.instances.size(), 2u);
  const Material& material = panel.material_of(panel.instances[1]);
  EXPECT_EQ(material.emission.v.b, 9);
  const Mesh& mesh = panel.meshes[size_t(panel.instances[1].mesh)];
  EXPECT_NEAR(triangle_cross(mesh, mesh.triangles[0]).z, -0.5f, 1e-6f) << "1 m x 0.5 m, towards -z";
  const Scene disc = light({{"type", "disc"}, {"radius", 0.5}, {"both_sides", true}});
  EXPECT_NEAR(std::get<Disc>(disc.primitives.at(0)).radius, 1, 1e-5f);

  for (const Json& wrong :
       {Json({{"type", "neon"}}), Json({{"type", "disc"}, {"radius", 0}}), Json({{"type", "rectangle"}, {"width", -1}}),
        Json({{"type", "warn"}, {"exponent", -1}}), Json({{"type", "spot"}, {"outer_angle", 4}}),
        Json({{"type", "point"}, {"intensity", {-1, 0, 0}}}), Json({{"type", "point"}, {"attenuation", {0, 0, 0}}})}) {
    node["extras"]["aktina"]["light"] = wrong;
    EXPECT_NE(file.fault().find("/nodes/0/extras/aktina/light"), std::string::npos) << wrong;
  }
}

TEST(GltfMaterials, ClassicCoefficientsAloneGiveThePhysicalForm) {
  GltfFile file;
  file.triangle();
  file.json["materials"] = Json::parse(R"([{"doubleSided": true, "extras": {"aktina": {"kd": [0.6, 0.1, 0.2]}}}])");
  const Material matt = file.read().materials.at(0);
  EXPECT_EQ(matt.base_colour, Rgb(0.6f, 0.1f, 0.2f));
  EXPECT_EQ(matt.metallic, 0);
  EXPECT_EQ(matt.specular_weight, 0);
  EXPECT_TRUE(matt.double_sided);
  EXPECT_EQ(matt.classic->ka, matt.classic->kd);
  EXPECT_EQ(matt.classic->ks, Rgb(0));

  file.json["materials"][0]["pbrMetallicRoughness"] = {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}, {"metallicFactor", 0}};
  const Material both = file.read().materials.at(0);
  EXPECT_EQ(both.base_colour, Rgb(0.5f)) << "what is stated stands";
  EXPECT_EQ(both.classic->kd, Rgb(0.6f, 0.1f, 0.2f));
}

TEST(GltfMaterials, SpecularGlossinessIsADielectricOfThatReflectance) {
  GltfFile file;
  file.triangle();
  file.json["extensionsUsed"] = {"KHR_materials_pbrSpecularGlossiness"};
  file.json["materials"] = Json::parse(R"([{"extensions": {"KHR_materials_pbrSpecularGlossiness":
      {"diffuseFactor": [0.5, 0.25, 0, 1], "specularFactor": [0.2, 0.1, 0.05], "glossinessFactor": 1}}}])");
  const Scene scene = file.read();
  const Surface s = surface_of(scene.materials.at(0));
  EXPECT_EQ(s.kd, Rgb(0.5f, 0.25f, 0));
  EXPECT_NEAR(s.kr.r, 0.2, 1e-6) << "a smooth surface mirrors its reflectance at normal incidence";
  EXPECT_NEAR(s.kr.b, 0.05, 1e-6);
}

TEST(GltfMaterials, NumbersOutOfRangeAreBroughtIntoIt) {
  GltfFile file;
  file.triangle();
  file.json["materials"] = {{{"pbrMetallicRoughness", {{"roughnessFactor", 1.5}, {"metallicFactor", -1}}}}};
  const Scene scene = file.read();
  EXPECT_EQ(scene.materials.at(0).roughness, 1);
  EXPECT_EQ(scene.materials.at(0).metallic, 0);
  EXPECT_EQ(warned(scene, "/materials/*/pbrMetallicRoughness/roughnessFactor"), 1u);
}

TEST(GltfLights, ShineAlongTheirNodes) {
  GltfFile file;
  file.triangle();
  file.json["extensionsUsed"] = {"KHR_lights_punctual"};
  file.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}, {"intensity", 3}}};
  const float s = 0.70710678f;  // a quarter turn about x: -z becomes +y
  file.json["nodes"][0]["rotation"] = {s, 0, 0, s};
  file.json["nodes"][0]["scale"] = {5, 5, 5};
  file.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  const Scene scene = file.read();
  const auto& light = std::get<DirectionalLight>(scene.lights.at(0).light);
  EXPECT_NEAR(light.direction.y, 1, 1e-6);
  EXPECT_EQ(light.e_perp.v, Rgb(3)) << "nodes do not scale light";
}

TEST(GltfLights, BrokenProfilesLeaveTheirLampOut) {
  GltfFile file;
  file.triangle();
  file.json["extensionsUsed"] = {"EXT_lights_ies"};
  file.json["extensions"]["EXT_lights_ies"]["lights"] = {{{"uri", "data:,nothing"}}};
  file.json["nodes"][0]["extensions"]["EXT_lights_ies"] = {{"light", 0}};
  const Scene scene = file.read();
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(warned(scene, "IES profile is missing or broken"), 1u);
}

TEST(GltfLights, TurnedLuminairesHaveTheirTiltFactor) {
  GltfFile file;
  file.triangle();
  file.json["extensionsUsed"] = {"EXT_lights_ies"};
  file.json["extensions"]["EXT_lights_ies"]["lights"] = {
      {{"uri",
        "data:,TILT=INCLUDE%0A1%0A2%0A0%2090%0A1%200.5%0A1%20-1%201%202%201%201%201%201%201%200%0A1%201%2015%0A0%20180%"
        "0A0%0A1%201%0A"}}};
  file.json["nodes"][0]["extensions"]["EXT_lights_ies"] = {{"light", 0}};  // aims along -z
  const Scene scene = file.read();
  EXPECT_NEAR(std::get<LuminaireLight>(scene.lights.at(0).light).colour.r, 0.5f, 1e-6) << "horizontal";
}

TEST(GltfFiles, BesideADocumentOnlyAndByEncodedNames) {
  test::TemporaryFolder outer;
  const Path folder = outer / "scene";
  std::filesystem::create_directories(folder / "a b");
  GltfFile file;
  file.triangle();
  const std::vector<uint8_t> glb = file.bytes();
  const std::vector<uint8_t> data(glb.end() - 36, glb.end());
  const auto load = [&](const std::string& uri) {
    file.json["buffers"][0]["uri"] = uri;
    write_file(folder / "scene.gltf", file.json.dump());
    return load_scene(folder / "scene.gltf").meshes.size();
  };
  write_file(folder / "a b" / Path(u8"č#1.bin"), data);
  write_file(outer / "outside.bin", data);
  EXPECT_EQ(load("a%20b/%C4%8D%231.bin"), 1u);
  EXPECT_EQ(load("a b/../a b/č%231.bin"), 1u) << "unencoded, and a .. that stays inside";
  for (const std::string& uri :
       {std::string("../outside.bin"), std::string("a%20b/../../outside.bin"), std::string("%2E%2E/outside.bin"),
        (outer / "outside.bin").string(), std::string("file:///etc/passwd"), std::string("https://a/b.bin")})
    EXPECT_THROW(load(uri), Error) << uri;
  std::filesystem::create_symlink(outer / "outside.bin", folder / "link.bin");
  EXPECT_THROW(load("link.bin"), Error) << "links do not lead outside";
}

}  // namespace
}  // namespace aktina
