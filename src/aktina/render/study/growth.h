// How cost and error grow with finer meshes and larger pictures.
#pragma once

#include "aktina/render/study/variant.h"

namespace aktina {

/// Each triangle cut in four by the middles of its edges, where normals are made unit again; flat triangles stay flat.
/// @pre  scene without primitives
Scene subdivided(const Scene& scene);

/// Slope of the line through (log x, log y) by least squares; unknown with fewer than two points that have one.
double log_log_slope(std::span<const double> x, std::span<const double> y);

/// Everything that the parts of a study share.
struct StudyWork {
  const Scene& scene;  // without primitives
  const StudyFamily& family;
  const StudyOptions& options;
  const Camera& camera;
  int width, height;
  int threads;  // all of them
  std::string reference;
  int reference_samples;
  Progress& progress;
  Study& study;
};

/// Fills MethodStudy::growth of the methods that draw the scene.
void measure_growth(StudyWork& work);

}  // namespace aktina
