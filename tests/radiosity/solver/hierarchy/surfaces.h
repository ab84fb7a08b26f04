// Scenes as solvers on trees see them.
#pragma once

#include <cmath>

#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/receiver_surfaces.h"
#include "aktina/radiosity/solver/shots.h"
#include "radiosity/scenes.h"

namespace aktina {

/// All light on all patches.
struct Surfaces {
  Surfaces(Scene given, double patch_size)
      : scene(std::move(given)),
        mesh(mesh_of(scene, patch_size)),
        sides(mesh),
        visibility(scene),
        geometry(sides),
        surfaces(scene, geometry, visibility),
        factors(geometry, visibility, surfaces, 16, 0),
        problem(sides.problem()) {}

  Scene scene;
  PatchMesh mesh;
  Sides sides;
  Visibility visibility;
  ShotGeometry geometry;
  ReceiverSurfaces surfaces;
  RayCastShots factors;
  RadiosityProblem problem;

  /// The same in one band, as green sees it.
  RadiosityProblem green() const {
    RadiosityProblem one = problem;
    one.bands = 1, one.weights = {1};
    one.reflectances.clear(), one.emissions.clear(), one.passing.clear();
    for (size_t s = 0; s < problem.size(); ++s) {
      one.reflectances.push_back(problem.reflectances[3 * s + 1]);
      one.emissions.push_back(problem.emissions[3 * s + 1]);
    }
    return one;
  }

 private:
  static PatchMesh mesh_of(const Scene& scene, double size) {
    Warnings warnings;
    return make_method(meshers(), "mesher", "uniform")->mesh(scene, {.patch_size = size, .coarse = 1}, warnings);
  }
};

/// A closed room with a lamp in its ceiling; with a box on its floor.
inline Scene lit_room(bool box) {
  Scene scene = room({2, 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  add_quad(scene, {0.7f, 1.999f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
  if (box) add_box(scene, {0.5f, 0, 0.5f}, {0.5f, 0.8f, 0.5f}, Rgb(0.7f));
  return scene;
}

/// Area-weighted root of the mean square of relative differences.
inline double difference(const RadiosityProblem& p, const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0, mean = 0, area = 0;
  for (size_t k = 0; k < a.size(); ++k) {
    const double w = p.areas[k / p.bands];
    squares += w * (a[k] - b[k]) * (a[k] - b[k]), mean += w * b[k], area += w;
  }
  return std::sqrt(squares / area) / (mean / area);
}

}  // namespace aktina
