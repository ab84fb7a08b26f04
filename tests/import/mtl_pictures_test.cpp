// Pictures of MTL materials: what a material here has in one picture is put together from several.
#include <gtest/gtest.h>

#include <fstream>

#include "aktina/image/file_format.h"
#include "aktina/import/import.h"
#include "test_files.h"

namespace aktina {
namespace {

class MtlPictures : public testing::Test {
 protected:
  /// A picture of one grey, 0 .. 1 as it is stored.
  void save(const std::string& name, float grey, int size = 1) {
    ImageWriteOptions options;
    options.tone_mapping.exposure = 1;
    write_image(folder_ / name, Image(size, size, 3, srgb_to_linear(grey)), options);
  }
  Scene read(const std::string& statements) {
    std::ofstream(folder_ / "a.mtl") << "newmtl m\n" << statements;
    std::ofstream(folder_ / "a.obj") << "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    return load_scene(folder_ / "a.obj");
  }
  static MaterialPoint at(const Scene& scene) {
    const Vec2 uv[2] = {{0.5f, 0.5f}, {0.5f, 0.5f}};
    return evaluate(scene, scene.materials.at(0), uv, Vec4(1));
  }
  static bool warned(const Scene& scene, std::string_view part) {
    for (const auto& item : scene.warnings.items())
      if (item.text.find(part) != std::string::npos) return true;
    return false;
  }

  test::TemporaryFolder folder_;
};

TEST_F(MtlPictures, OpacityOfItsOwnBecomesAlpha) {
  save("kd.png", 1, 2), save("d.png", 0.25f);
  const Scene scene = read("Kd 0.5 0.5 0.5\nd 0.8\nmap_Kd kd.png\nmap_d d.png\n");
  EXPECT_NEAR(at(scene).alpha, 0.8f * 0.25f, 0.003f) << "d times its picture, which is not decoded from sRGB";
  EXPECT_NEAR(at(scene).surface.kd.r, 0.5f, 1e-5);
  EXPECT_EQ(scene.images.at(size_t(scene.materials.at(0).base_texture.image)).width(), 2) << "as large as the largest";
}

TEST_F(MtlPictures, OpacityNeedsNoColours) {
  save("d.png", 0.5f);
  const Scene scene = read("Kd 0.2 0.4 0.6\nmap_d d.png\n");
  EXPECT_NEAR(at(scene).alpha, 0.5f, 0.003f);
  EXPECT_NEAR(at(scene).surface.kd.g, 0.4f, 1e-5);
}

TEST_F(MtlPictures, OpacityThatIsMissingOrLiesElsewhereIsSaid) {
  save("kd.png", 1), save("d.png", 0.5f);
  const Scene missing = read("map_Kd kd.png\nmap_d nowhere.png\n");
  EXPECT_EQ(at(missing).alpha, 1);
  EXPECT_TRUE(warned(missing, "'nowhere.png' is missing"));
  const Scene elsewhere = read("map_Kd kd.png\nmap_d -s 2 2 d.png\n");
  EXPECT_EQ(at(elsewhere).alpha, 1);
  EXPECT_TRUE(warned(elsewhere, "lie unlike map_Kd"));
}

TEST_F(MtlPictures, RoughnessAndMetalAreOnePicture) {
  save("r.png", 0.4f), save("m.png", 0.8f);
  const Scene both = read("Kd 1 1 1\nPr 0.5\nmap_Pr r.png\nmap_Pm m.png\n");
  EXPECT_NEAR(at(both).surface.roughness, 0.5f * 0.4f, 0.003f);
  EXPECT_NEAR(at(both).surface.metallic, 0.8f, 0.003f) << "Pm is not stated";
  const Scene rough = read("Kd 1 1 1\nmap_Pr r.png\n");
  EXPECT_NEAR(at(rough).surface.roughness, 0.4f, 0.003f);
  EXPECT_EQ(at(rough).surface.metallic, 0);
}

TEST_F(MtlPictures, MaterialsShareWhatIsPutTogether) {
  save("kd.png", 1), save("d.png", 0.5f);
  const std::string maps = "map_Kd kd.png\nmap_d d.png\n";
  EXPECT_EQ(read(maps + "newmtl other\n" + maps).images.size(), 3u);
}

}  // namespace
}  // namespace aktina
