// The classic comparison of shading methods, on scenes that are built here: `aktina study --paper`.
#pragma once

#include "aktina/render/study/study.h"

namespace aktina {

/// A scene at growing tessellation, coarse first: the studies look at the coarsest, where methods differ most.
struct PaperScene {
  std::string name;
  std::vector<Scene> levels;
};

/// Sphere, torus, a strip bent like an S, and Newell's teapot, each of one shiny material before two lamps.
std::vector<PaperScene> paper_scenes();

/// Newell's teapot of 32 bicubic patches, each cut into 2 n n triangles with the patches' own normals; 2 m wide, y up.
Mesh teapot(int n);

/// A study of each of them. `options.levels` is not read.
/// @return  those that were finished or begun where `progress` is cancelled; the last one may be incomplete
/// @throws Error as study()
std::vector<Study> study_paper(const StudyOptions& options, Progress& progress);

}  // namespace aktina
