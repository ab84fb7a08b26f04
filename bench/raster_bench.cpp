// The rasterizer: each shading method against Gouraud's.
#include "aktina/raster/rasterize.h"
#include "aktina/raster/shading/shading_method.h"
#include "bench/report.h"
#include "tests/raster/scenes.h"

namespace {

using namespace aktina;

Scene bumpy_scene(int columns, int rows) {
  Scene scene;
  const int plastic = test::add_material(
      scene, {.ka = {0.2f, 0.15f, 0.1f}, .kd = {0.6f, 0.45f, 0.3f}, .ks = Rgb(0.4f), .exponent = 32});
  test::add_mesh(scene, test::bumpy_sphere(columns, rows), plastic);
  for (const Point3 p : {Point3{3, 3, 4}, {-4, 1, 3}, {0, -3, 4}})
    scene.lights.push_back({"lamp", PointLight{p, Intensity(Rgb(30)), {}}, -1});
  scene.ambient = Rgb(0.5f);
  scene.cameras.push_back(look_at({0, 0, 3.2f}, {0, 0, 0}, {0, 1, 0}, 0.7346f));
  return scene;
}

void methods_against_gouraud() {
  const Scene scene = bumpy_scene(32, 31);
  for (const ShadingRow* row : shading_methods()) {
    RasterOptions method, gouraud;
    method.shading = std::string(row->info.id), gouraud.shading = "gouraud";
    const auto t = bench::race(3, {[&] { rasterize(scene, scene.cameras[0], 128, 128, method); },
                                   [&] { rasterize(scene, scene.cameras[0], 128, 128, gouraud); }});
    bench::report(fmt::format("shading.{}.gouraud", row->info.id),
                  fmt::format("{} shading: time of a frame over Gouraud's", row->info.id), t[0] / t[1], "x");
  }
}

}  // namespace

int main() { methods_against_gouraud(); }
