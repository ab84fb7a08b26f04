// Surfaces -> patches: what radiosity is computed on.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>

#include "aktina/base/method.h"
#include "aktina/base/warnings.h"
#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct MeshOptions {
  double patch_size = 0;          // m, longest edge; 0: chosen from the area of the surfaces
  double usual_patches = 12'000;  // about so many where the size is chosen
  double coarse = 4;              // longest edge of what shoots together, in patch sizes
  double most_coarse = 1e9;       // what shoots together may be larger where there would be more of it
  uint64_t most_patches = 2'000'000;

  /// m, for surfaces of `area`, m^2.
  double size(double area) const { return patch_size > 0 ? patch_size : std::sqrt(area / usual_patches); }
  double coarse_size(double area) const { return std::max(coarse * size(area), std::sqrt(area / most_coarse)); }
};

/// Patches that may be split into four where the light on them changes fast, once that is known.
struct Refinement {
  int depth = 0;        // how often; 0: the mesh stays as it is
  double gradient = 0;  // what changes fast: difference of light within a patch, in target errors
};

class Mesher {
 public:
  virtual ~Mesher() = default;
  /// @param scene  without analytic primitives (TessellatedScene)
  /// @throws Error limit (more patches than allowed, before memory is taken), bad_input (no surface)
  virtual PatchMesh mesh(const Scene& scene, const MeshOptions& options, Warnings& warnings) const = 0;
  virtual Refinement refinement() const { return {}; }
};

std::span<const Method<std::unique_ptr<Mesher>>* const> meshers();

}  // namespace aktina
