// Surfaces -> patches: what radiosity is computed on.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "aktina/base/method.h"
#include "aktina/base/warnings.h"
#include "aktina/radiosity/solution.h"
#include "aktina/scene/scene.h"

namespace aktina {

struct MeshOptions {
  double patch_size = 0;  // m, longest edge; 0: chosen from the area of the surfaces
  uint64_t most_patches = 2'000'000;
};

class Mesher {
 public:
  virtual ~Mesher() = default;
  /// @param scene  without analytic primitives (TessellatedScene)
  /// @throws Error limit (more patches than allowed, before memory is taken), bad_input (no surface)
  virtual PatchMesh mesh(const Scene& scene, const MeshOptions& options, Warnings& warnings) const = 0;
};

std::span<const Method<std::unique_ptr<Mesher>>* const> meshers();

}  // namespace aktina
