// Solvers on trees: links a second against the radiosity benchmark of SPLASH-3, how links and time grow with the
// leaves, and each basis at one target error. One thread.
#include <cmath>
#include <string>

#include "aktina/base/parallel.h"
#include "aktina/import/import.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"
#include "aktina/radiosity/solver/shots.h"
#include "aktina/scene/tessellate.h"
#include "bench/report.h"

namespace {

using namespace aktina;

constexpr double kSplashLinks = 168'919 / 0.68;  // a second, one core: SPLASH-3, radiosity, its largest room

/// The Cornell box, all light on all patches.
struct Cornell {
  explicit Cornell(double patch_size)
      : file(load_scene(std::string(AKTINA_SOURCE_DIR) + "/scenes/cornell.glb")),
        scene(file),
        mesh(mesh_of(*scene, patch_size)),
        sides(mesh),
        visibility(*scene),
        geometry(sides),
        surfaces(*scene, geometry, visibility),
        problem(sides.problem()) {}
  static PatchMesh mesh_of(const Scene& scene, double size) {
    Warnings warnings;
    return make_method(meshers(), "mesher", "uniform")->mesh(scene, {.patch_size = size, .coarse = 1}, warnings);
  }

  Scene file;
  TessellatedScene scene;
  PatchMesh mesh;
  Sides sides;
  Visibility visibility;
  ShotGeometry geometry;
  ReceiverSurfaces surfaces;
  RadiosityProblem problem;
};

struct Run {
  double links = 0, leaves = 0, seconds = 1e30;
};

/// Links in four passes with three exchanges after each, as a solve begins.
Run run(const Cornell& cornell, double most) {
  Run result;
  for (int round = 0; round < 3; ++round) {
    Run one;
    one.seconds = bench::seconds([&] {
      LinkedTree h(cornell.problem, cornell.surfaces, {.most = most}, 0);
      for (const double times : {64.0, 16.0, 4.0, 1.0}) {
        h.link(times, nullptr);
        for (int k = 0; k < 3; ++k) h.exchange();
      }
      one.links = double(h.links().size()), one.leaves = double(h.leaves());
    });
    if (one.seconds < result.seconds) result = one;
  }
  return result;
}

}  // namespace

int main() {
  set_thread_count(1);
  const Cornell cornell(0.01);
  const Run few = run(cornell, 1e-4), many = run(cornell, 3e-6);
  bench::report("hierarchy.links", "links of the Cornell box, light exchanged twelve times", many.links, "1");
  bench::report("hierarchy.splash", "links a second, against SPLASH-3 radiosity (168,919 in 0.68 s)",
                many.links / many.seconds / kSplashLinks, "x", bench::Goal{4});
  const double leaves = std::log(many.leaves / few.leaves);
  bench::report("hierarchy.link_growth", "log links over log leaves", std::log(many.links / few.links) / leaves, "1");
  bench::report("hierarchy.time_growth", "log time over log leaves", std::log(many.seconds / few.seconds) / leaves,
                "1");
  const Cornell coarse(0.05);
  const RayCastShots factors(coarse.geometry, coarse.visibility, coarse.surfaces, 4, 0);
  for (const char* method : {"hierarchical", "clustering", "wavelet_haar", "wavelet_m2", "wavelet_m3", "wavelet_f2"}) {
    const auto solver = make_method(solvers(), "radiosity", method);
    double least = 1e30;
    for (int round = 0; round < 3; ++round)
      least =
          std::min(least, bench::seconds([&] {
                     solver->solve(coarse.problem, factors, {.tolerance = 1e-3, .target_error = 0.02, .each_step = {}});
                   }));
    bench::report(std::string("hierarchy.") + method, "Cornell box, all light, target error 0.02", least, "s");
  }
  return 0;
}
