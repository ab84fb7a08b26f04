// What a lightmapped glTF file shows is what the solution says: written, read back by the importer, drawn or looked up.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/export/lightmap_files.h"
#include "aktina/image/file_format.h"
#include "aktina/import/import.h"
#include "aktina/radiosity/solve.h"
#include "aktina/raster/rasterize.h"
#include "render/job_scenes.h"
#include "test_files.h"

namespace aktina {
namespace {

constexpr float kExposure = 0.005f;  // nothing clips

struct Baked {
  Scene scene = test::lit_floor();
  Solution solution;
  Lightmap map;

  Baked() {
    RadiosityOptions options;
    options.patch_size = 0.25;
    solution = solve_radiosity(scene, options);
    LightmapOptions lightmap;
    lightmap.texel_size = 0.05, lightmap.direct_samples = 0;
    map = make_lightmap(scene, solution, lightmap);
  }
  Scene written(LightmapForm form, const char* name) const {
    const test::TemporaryFolder folder;
    write_lightmapped_gltf(folder / name, scene, solution, map, form, {.exposure = kExposure, .metadata = {}});
    return load_scene(folder / name);
  }
};

TEST(LightmappedGltf, EmissiveShowsTheExposedSolution) {
  const Baked baked;
  for (const char* const name : {"lit.glb", "lit.gltf"}) {
    const Scene read = baked.written(LightmapForm::emissive, name);
    RasterOptions viewer;
    viewer.cull_back_faces = true;
    const Image shown = rasterize(read, read.cameras[0], 48, 32, viewer).layers[0].image;
    const Image truth = render_solution(baked.scene, baked.solution, baked.scene.cameras[0], 48, 32, 1).layers[0].image;
    double error = 0, level = 0;
    for (size_t i = 0; i < truth.pixels.size(); ++i) {
      const double expected = double(kExposure * truth.pixels[i]);
      EXPECT_NEAR(double(shown.pixels[i]), expected, 0.05 * expected + 2e-3) << i;
      error += std::fabs(double(shown.pixels[i]) - expected), level += expected;
    }
    EXPECT_LT(error, 0.015 * level) << "codes of 8 bits";
    EXPECT_GT(level, 5) << "there is something to see";
  }
}

TEST(LightmappedGltf, LightmapTimesBaseOverPiIsTheExposedRadiance) {
  const Baked baked;
  const Scene read = baked.written(LightmapForm::lightmap, "lit.glb");
  ASSERT_EQ(read.images.size(), 1u);
  ASSERT_EQ(read.instances.size(), 2u);
  TextureImage picture;  // the importer leaves alone what only an extension that it does not know uses
  picture.pixels = std::get<Bitmap>(decode_texture(read.images[0].encoded, "lightmap"));
  double error = 0, level = 0;
  for (size_t v = 0; v < 4; ++v) {  // corners of the floor
    const Mesh& floor = read.meshes[0];
    ASSERT_EQ(floor.name, "floor");
    ASSERT_EQ(floor.uv[1].size(), 4u);
    const Vec4 texel =
        look_up(picture, {.image = 0, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp}, floor.uv[1][v], false);
    const double radiance = double(texel.x) * kPi * 0.5 * kInvPi;  // intensity pi, base 0.5
    for (size_t k = 0; k < baked.solution.mesh.positions.size(); ++k)
      if (length(baked.solution.mesh.positions[k] - floor.positions[v]) < 1e-5f) {
        const double expected = double(kExposure * baked.solution.vertex_radiosities[k].v.r) * kInvPi;
        error += std::fabs(radiance - expected), level += expected;
        break;
      }
  }
  EXPECT_GT(level, 0);
  EXPECT_LT(error, 4 * 0.5 / 255);
  EXPECT_EQ(read.materials[0].base_colour, Rgb(0.5f)) << "the base is kept";
}

TEST(LightmappedGltf, PagesOfTheirOwnMaterials) {
  Baked baked;
  LightmapOptions small;
  small.size = 64, small.texel_size = 4.0 / 55, small.direct_samples = 0;
  baked.scene.instances.push_back(baked.scene.instances[0]);
  baked.scene.instances.back().to_world[3] = Vec4(0, -1, 0, 1);
  RadiosityOptions options;
  options.patch_size = 0.5;
  baked.solution = solve_radiosity(baked.scene, options);
  baked.map = make_lightmap(baked.scene, baked.solution, small);
  ASSERT_EQ(baked.map.layout.pages.size(), 3u) << "two floors and the lamp";
  const Scene read = baked.written(LightmapForm::lightmap, "lit.glb");
  EXPECT_EQ(read.images.size(), 3u);
  EXPECT_GE(read.materials.size(), 3u + 2u) << "the floor's twice, the lamp's, and the originals";
}

}  // namespace
}  // namespace aktina
