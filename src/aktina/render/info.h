// The pre-flight check of a file: what it holds, what is odd about it, what each job will take. docs/info.md says what
// each number means.
#pragma once

#include <string>
#include <vector>

#include "aktina/import/import.h"
#include "aktina/scene/mesh_check.h"

namespace aktina {

struct FileInfo {
  /// A heading and lines of text, and the same as JSON.
  std::string text;
  std::string json;  // one object: {"kind": "scene" | "image" | "luminaire", ...}
  Warnings warnings;
};

/// Any file that Aktina reads. @throws Error bad_input, io, limit, unsupported
FileInfo file_info(const Path& path, const ImportOptions& options = {});

/// Mesh check of each object: all meshes of one node together, in world space.
struct ObjectCheck {
  std::string name;
  MeshCheck mesh;
};
std::vector<ObjectCheck> check_objects(const Scene& scene);

/// What a job is foreseen to take on this machine: an order of magnitude; docs/info.md has the formulas.
struct JobEstimate {
  std::string job;
  double bytes, seconds;
};
std::vector<JobEstimate> estimate_jobs(const Scene& scene);

/// Luminous flux of emissive surfaces, lm: pi L A, twice where both sides shine. Pictures on them are taken as white.
double emissive_flux(const Scene& scene);

}  // namespace aktina
