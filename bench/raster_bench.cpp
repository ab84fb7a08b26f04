// The rasterizer: each shading method against Gouraud's; whole frames against Mesa's llvmpipe on the same mesh.
#include <array>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/raster/rasterize.h"
#include "aktina/raster/shading/shading_method.h"
#include "bench/llvmpipe.h"
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

void methods_against_gouraud(const Scene& scene, std::string_view size) {
  set_thread_count(1);
  for (const ShadingRow* row : shading_methods()) {
    Rasterizer method(scene, {.shading = std::string(row->info.id)}), gouraud(scene, {.shading = "gouraud"});
    LayeredImage a, b;
    const auto t = bench::race(8, {[&] { method.draw(scene.cameras[0], 1024, 1024, a); },
                                   [&] { gouraud.draw(scene.cameras[0], 1024, 1024, b); }});
    bench::report(fmt::format("shading.{}.{}.gouraud", row->info.id, size),
                  fmt::format("{} shading, {} triangles: time of a frame over Gouraud's", row->info.id, size),
                  t[0] / t[1], "x");
  }
  set_thread_count(0);
}

constexpr int kSize = 1024;

/// Share of the pixels that differ by more than 8 / 255 in a channel.
double share_different(const Image& ours, const std::vector<float>& theirs) {
  size_t different = 0;
  for (size_t i = 0; i < theirs.size(); i += 3) {
    bool far = false;
    for (size_t k = 0; k < 3; ++k)
      far = far || std::abs(std::min(ours.pixels[i + k], 1.0f) - theirs[i + k]) > 8 / 255.0f;
    different += far;
  }
  return 3 * double(different) / double(theirs.size());
}

/// Our frame and llvmpipe's, in turn. @return  seconds of both
std::array<double, 2> against_llvmpipe(const Scene& scene, const std::string& shading, const std::string& size,
                                       int threads, double goal) {
  // llvmpipe's threads are helpers: 0 leaves all the work to the calling thread.
  bench::Llvmpipe peer(scene, kSize, threads == 1 ? 0 : threads);
  if (!peer.missing().empty()) {
    fmt::print(stderr, "raster: not compared with llvmpipe: {}\n", peer.missing());
    return {};
  }
  set_thread_count(threads);
  Rasterizer ours(scene, {.shading = shading});
  LayeredImage picture;
  const auto t = bench::race(
      30, {[&] { ours.draw(scene.cameras[0], kSize, kSize, picture); }, [&] { peer.draw(shading == "phong"); }});
  const std::string id = fmt::format("raster.{}.{}.threads{}", shading, size, threads);
  bench::report(id + ".llvmpipe",
                fmt::format("{} shading, {} triangles, {} threads: time of {} over ours ({:.2f} ms)", shading, size,
                            threads, peer.renderer(), t[0] * 1e3),
                t[1] / t[0], "x", bench::Goal{goal});
  if (threads == 1)
    bench::report(id + ".difference", "share of pixels that differ from llvmpipe's by more than 8/255",
                  share_different(picture.layers[0].image, peer.read()), "1", bench::Goal{0.01, false});
  set_thread_count(0);
  return {t[0], t[1]};
}

/// What a second thread brings, both in turn.
void scaling(const Scene& scene, const std::string& shading) {
  Rasterizer one(scene, {.shading = shading}), two(scene, {.shading = shading});
  LayeredImage a, b;
  const auto frame = [&](Rasterizer& rasterizer, int threads, LayeredImage& out) {
    set_thread_count(threads);
    rasterizer.draw(scene.cameras[0], kSize, kSize, out);  // the arena's first frame starts its threads
    return bench::seconds([&] { rasterizer.draw(scene.cameras[0], kSize, kSize, out); });
  };
  double least[2] = {1e30, 1e30};
  for (int round = 0; round < 12; ++round) {
    least[0] = std::min(least[0], frame(one, 1, a));
    least[1] = std::min(least[1], frame(two, 2, b));
  }
  set_thread_count(0);
  bench::report(fmt::format("raster.{}.70k.scaling", shading),
                fmt::format("{} shading, 70k triangles: time on 1 thread over 2", shading), least[0] / least[1], "x",
                bench::Goal{1.85});
}

}  // namespace

int main() {
  const Scene fine = bumpy_scene(188, 186), coarse = bumpy_scene(32, 31);
  methods_against_gouraud(fine, "70k");
  methods_against_gouraud(coarse, "2k");
  for (const int threads : {1, 2})
    for (const char* shading : {"gouraud", "phong"}) {
      against_llvmpipe(fine, shading, "70k", threads, 5);
      against_llvmpipe(coarse, shading, "2k", threads, 3.5);
    }
  for (const char* shading : {"gouraud", "phong"}) scaling(fine, shading);
}
