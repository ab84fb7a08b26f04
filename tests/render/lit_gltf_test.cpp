// What a lit glTF file shows is what the solution says: written, read back, drawn without computing light.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/export/export.h"
#include "aktina/import/import.h"
#include "aktina/radiosity/solve.h"
#include "aktina/raster/rasterize.h"
#include "render/job_scenes.h"
#include "test_files.h"

namespace aktina {
namespace {

TEST(LitGltfReadBack, ShowsTheExposedSolution) {
  const Scene scene = test::lit_floor();
  RadiosityOptions options;
  options.patch_size = 0.5;
  const Solution solution = solve_radiosity(scene, options);
  const test::TemporaryFolder folder;
  constexpr float kExposure = 0.005f;  // nothing clips
  for (const char* const name : {"lit.glb", "lit.gltf"}) {
    LitGltfOptions lit;
    lit.exposure = kExposure;
    write_lit_gltf(folder / name, scene, solution, lit);
    const Scene read = load_scene(folder / name);
    ASSERT_EQ(read.cameras.size(), 1u);
    RasterOptions viewer;
    viewer.cull_back_faces = true;  // as glTF asks of single-sided materials
    const Image shown = rasterize(read, read.cameras[0], 48, 32, viewer).layers[0].image;
    const Image truth = render_solution(scene, solution, scene.cameras[0], 48, 32, 1).layers[0].image;
    double brightest = 0;
    for (size_t i = 0; i < truth.pixels.size(); ++i) {
      const double expected = double(kExposure * truth.pixels[i]);
      EXPECT_NEAR(double(shown.pixels[i]), expected, 1e-4 * expected + 1e-6) << name << " " << i;
      brightest = std::max(brightest, expected);
    }
    EXPECT_GT(brightest, 0.01) << "there is something to see";
  }
}

}  // namespace
}  // namespace aktina
