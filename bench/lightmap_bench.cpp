// Lightmaps: how long 100,000 triangles take to be laid out, and how many texels are lit a second.
#include <string>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/import/import.h"
#include "aktina/radiosity/lightmap/lightmap.h"
#include "aktina/radiosity/lightmap/pack.h"
#include "aktina/radiosity/solve.h"
#include "aktina/scene/tessellate.h"
#include "bench/report.h"
#include "tests/raster/scenes.h"

namespace {

using namespace aktina;

/// A mesh as a surface of a solution, without light.
LightmapSurface surface_of(Mesh mesh) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({.mesh = 0});
  Solution solution;
  solution.mesh.patches.push_back({0, 0, 0, 0});
  solution.mesh.centres.push_back({0, 0, 0, 0});
  solution.mesh.two_sided.push_back(0);
  return lightmap_surfaces(scene, solution)[0];
}

/// Triangles that have no neighbours: each is a chart.
Mesh loose_triangles(uint32_t count) {
  Mesh mesh;
  Pcg32 random(1);
  const auto near = [&](Point3 p) { return p + 0.1f * Vec3(random.uniform(), random.uniform(), random.uniform()); };
  for (uint32_t i = 0; i < count; ++i) {
    const Point3 p(100 * random.uniform(), 100 * random.uniform(), 100 * random.uniform());
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(near(p));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

void lay_out(const char* id, const char* what, Mesh mesh, int size) {
  std::vector<Chart> charts;
  LightmapLayout layout;
  LightmapSurface surface;
  LightmapOptions options;
  options.size = size;
  set_thread_count(1);
  const double t = bench::race(2, {[&] { layout = make_layout({surface = surface_of(mesh)}, options); }})[0];
  set_thread_count(0);
  bench::report(id, what, t, "s", bench::Goal{1.0, false});
  double used = 0;
  for (const PlacedChart& c : layout.charts) used += double(c.width) * double(c.height);
  bench::report(std::string(id) + ".charts", "the same: charts", double(layout.charts.size()), "1");
  bench::report(std::string(id) + ".used", "the same: share of the page in use", used / double(size) / double(size),
                "1");
}

void light_texels(const Scene& scene) {
  const Solution solution = solve_radiosity(scene, {});
  LightmapOptions options;
  options.size = 1024;
  const auto rate = [&](int direct, int gather) {
    options.direct_samples = direct, options.gather_samples = gather;
    Lightmap map;
    const double t = bench::race(1, {[&] { map = make_lightmap(scene, solution, options); }})[0];
    return double(map.texels.size()) / t;
  };
  bench::report("lightmap.texels", "room.glb, 1024 x 1024, light of the solution, all threads, layout to seams",
                rate(0, 0), "texels/s");
  bench::report("lightmap.direct", "the same, direct light by 16 rays a texel", rate(16, 0), "texels/s");
  options.size = 256;
  bench::report("lightmap.gather", "256 x 256, all light by 16 + 64 rays a texel", rate(16, 64), "texels/s");
}

}  // namespace

int main() {
  lay_out("lightmap.smooth", "charts and packing of a bumpy sphere of 99,904 triangles, one thread",
          test::bumpy_sphere(224, 224), 4096);
  lay_out("lightmap.loose", "charts and packing of 100,000 triangles without neighbours, one thread",
          loose_triangles(100'000), 4096);
  light_texels(load_scene(std::string(AKTINA_SOURCE_DIR) + "/scenes/room.glb"));
  return 0;
}
