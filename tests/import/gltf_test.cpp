#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/import/import.h"
#include "test_files.h"

namespace aktina {
namespace {

using Json = nlohmann::json;

std::vector<uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

Scene read(const std::string& text, const ImportOptions& options = {}) {
  return read_gltf(bytes_of(text), "/nowhere", "test.gltf", options);
}
Scene read(const Json& json, const ImportOptions& options = {}) { return read(json.dump(), options); }

/// One triangle (0,0,0) (1,0,0) (0,1,0) as a data URI: nine floats.
Json triangle() {
  return {{"asset", {{"version", "2.0"}}},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes", {{{"mesh", 0}}}},
          {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
          {"buffers",
           {{{"byteLength", 36},
             {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}}},
          {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
          {"accessors",
           {{{"bufferView", 0},
             {"componentType", 5126},
             {"count", 3},
             {"type", "VEC3"},
             {"min", {0, 0, 0}},
             {"max", {1, 1, 0}}}}}};
}

/// Text of the error; its code must be one of a file's faults.
std::string fault(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == Code::bad_input || error.code() == Code::limit || error.code() == Code::unsupported ||
                error.code() == Code::io)
        << error.what();
    return error.what();
  }
  return {};
}

std::string changed(const std::function<void(Json&)>& change) {
  Json json = triangle();
  change(json);
  return fault(json.dump());
}

TEST(Gltf, ReadsATriangle) {
  const Scene scene = read(triangle());
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(triangle_count(scene), 1U);
}

TEST(Gltf, FaultsAreRefusedWithTheirPlace) {
  EXPECT_NE(changed([](Json& j) { j["accessors"][0]["count"] = 4294967295U; }).find("/accessors/0"), std::string::npos);
  EXPECT_NE(changed([](Json& j) { j["accessors"][0]["byteOffset"] = 4; }).find("/accessors/0"), std::string::npos);
  EXPECT_NE(changed([](Json& j) { j["accessors"][0]["componentType"] = 7; }).find("/accessors/0/componentType"),
            std::string::npos);
  EXPECT_NE(changed([](Json& j) { j["nodes"][0]["mesh"] = 9; }).find("/nodes/0/mesh"), std::string::npos);
  EXPECT_NE(changed([](Json& j) { j["nodes"][0]["mesh"] = "a"; }).find("/nodes/0/mesh"), std::string::npos);
  EXPECT_NE(changed([](Json& j) { j["nodes"][0]["children"] = {0}; }), "");
  EXPECT_NE(changed([](Json& j) { j["asset"]["version"] = "1.0"; }), "");
  EXPECT_NE(changed([](Json& j) {
              j["extensionsUsed"] = {"XYZ_unknown"};
              j["extensionsRequired"] = {"XYZ_unknown"};
            }).find("XYZ_unknown"),
            std::string::npos);
  EXPECT_NE(changed([](Json& j) { j["buffers"][0]["uri"] = "../../etc/passwd"; }), "");
  EXPECT_NE(changed([](Json& j) { j["buffers"][0]["uri"] = "missing.bin"; }), "");
  EXPECT_NE(fault("{"), "");
  EXPECT_NE(fault(std::string(200000, '[')), "");
}

TEST(Gltf, AMissingPictureIsWhiteAndSaid) {
  Json json = triangle();
  json["images"] = {{{"uri", "missing.png"}}};
  json["textures"] = {{{"source", 0}}};
  json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  json["meshes"][0]["primitives"][0]["material"] = 0;
  const Scene scene = read(json);
  EXPECT_FALSE(scene.warnings.empty());
}

TEST(Gltf, AChainOfAHundredThousandNodesIsRead) {
  Json json = triangle();
  constexpr int kDepth = 100000;
  Json nodes = Json::array();
  for (int i = 0; i < kDepth; ++i) nodes.push_back({{"children", {i + 1}}});
  nodes.push_back({{"mesh", 0}});
  json["nodes"] = nodes;
  EXPECT_EQ(triangle_count(read(json)), 1U);
  json["nodes"][kDepth]["children"] = {0};  // and a circle of them is refused
  EXPECT_NE(fault(json.dump()), "");
}

TEST(Gltf, UnitsScaleEverything) {
  Json json = triangle();
  json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 4000}}});
  json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 10}}}}};
  json["scenes"][0]["nodes"] = {0, 1};
  ImportOptions options;
  options.metres_per_unit = 0.001;
  const Scene scene = read(json, options);
  EXPECT_NEAR(bounds(scene).high.x, 0.001f, 1e-9f);
  EXPECT_NEAR(scene.cameras.at(0).position().z, 4, 1e-5f);
  EXPECT_NEAR(scene.cameras.at(0).near, 0.01f, 1e-6f);
}

TEST(Gltf, ExtrasSayWhatGltfCannot) {
  Json json = triangle();
  json["materials"] = {{{"extras", {{"aktina", {{"kd", {0.1, 0.2, 0.3}}, {"exponent", 12}}}}}}};
  json["nodes"].push_back(
      {{"extras", {{"aktina", {{"primitive", {{"type", "sphere"}, {"radius", 2}, {"material", 0}}}}}}}});
  json["scenes"][0]["nodes"] = {0, 1};
  json["extras"] = {{"aktina", {{"ambient", {1, 2, 3}}}}};
  const Scene scene = read(json);
  ASSERT_EQ(scene.primitives.size(), 1U);
  EXPECT_EQ(std::get<Sphere>(scene.primitives[0]).radius, 2);
  EXPECT_EQ(surface_of(scene.materials[0]).kd, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(surface_of(scene.materials[0]).exponent, 12);
  EXPECT_EQ(scene.ambient, Rgb(1, 2, 3));
  EXPECT_NE(changed([](Json& j) { j["nodes"][0]["extras"]["aktina"]["primitive"]["type"] = "teapot"; }), "");
}

TEST(Gltf, InstancesComeFromParallelAccessors) {
  Json json = triangle();
  json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 0;
  const Scene scene = read(json);  // three copies, moved to the corners of the triangle itself
  ASSERT_EQ(scene.instances.size(), 3U);
  EXPECT_EQ(Vec3(scene.instances[1].to_world[3]), Vec3(1, 0, 0));
}

TEST(Gltf, LuminairesComeFromIesFiles) {
  Json json = triangle();
  json["extensionsUsed"] = {"EXT_lights_ies"};
  // IESNA:LM-63-2002, one plane, 100 cd at 0, 90 and 180 degrees
  const std::string ies =
      "SUVTTkE6TE0tNjMtMjAwMgpUSUxUPU5PTkUKMSAxMDAwIDEgMyAxIDEgMiAwIDAgMAoxID"
      "EgMTAKMCA5MCAxODAKMAoxMDAgMTAwIDEwMAo=";
  json["extensions"]["EXT_lights_ies"]["lights"] = {{{"uri", "data:application/octet-stream;base64," + ies}}};
  json["nodes"][0]["extensions"]["EXT_lights_ies"] = {{"light", 0}, {"multiplier", 2}};
  const Scene scene = read(json);
  ASSERT_EQ(scene.lights.size(), 1U);
  EXPECT_NEAR(flux(scene.lights[0].light)->v.g, 4 * kPi * 200, 1);
}

TEST(Gltf, DamagedFilesNeverDoMoreThanFail) {
  const std::vector<uint8_t> whole = read_file(Path(AKTINA_SOURCE_DIR) / "scenes/cornell.glb");
  Pcg32 random(11);
  for (int round = 0; round < 400; ++round) {
    std::vector<uint8_t> bytes = whole;
    if (round % 2) bytes.resize(random.next() % bytes.size());
    for (uint32_t k = 0; k < 1 + random.next() % 4 && !bytes.empty(); ++k)
      bytes[random.next() % std::min<size_t>(bytes.size(), 6000)] ^= uint8_t(1U << random.next() % 8);
    try {
      read_gltf(bytes, "/nowhere", "damaged.glb");
    } catch (const Error&) {
    }
  }
}

TEST(Gltf, EveryFileOfOthersIsReadOrRefused) {
  const Path folder = Path(AKTINA_SOURCE_DIR) / "../shared/scenes";
  if (!std::filesystem::is_directory(folder)) {
    std::puts("no third-party scenes beside the source: nothing was read");
    return;
  }
  int read_well = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = lower_extension(entry.path());
    if (extension != "gltf" && extension != "glb") continue;
    bool loaded = true, warned = false;
    std::string why;
    try {
      warned = !load_scene(entry.path(), {.default_camera = false, .default_light = false}).warnings.empty();
    } catch (const Error& error) {
      loaded = false;
      if (error.code() != Code::unsupported) why = error.what();
    }
    (loaded ? read_well : refused) += 1;
    Path report = entry.path();
    report += ".report.json";
    if (!std::filesystem::exists(report)) continue;
    const auto errors = Json::parse(read_text_file(report))["issues"]["numErrors"].get<int>();
    EXPECT_TRUE(errors > 0 || why.empty()) << entry.path() << ": valid, and refused: " << why;
    EXPECT_TRUE(errors == 0 || !loaded || warned) << entry.path() << ": broken, and read without a word";
  }
  EXPECT_GT(read_well, refused);
}

}  // namespace
}  // namespace aktina
