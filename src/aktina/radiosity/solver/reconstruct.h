// Values of patches -> values at vertices, for display.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/radiosity/solution.h"

namespace aktina {

/// How each vertex follows from the patches about it: weights of a linear fit. Smooth where the surface is: over
/// vertices in one place with nearly the same normal, whichever mesh they belong to. Exact for what is constant or
/// linear over a plane, at its border as well (from the second ring of patches there); never beyond the range of the
/// patches it is taken from, at a border by no more than half of it.
/// M. Cohen, J. Wallace, Radiosity and Realistic Image Synthesis, 1993, section 9.2 (there by averages and mirroring).
class Reconstruction {
 public:
  explicit Reconstruction(const PatchMesh& mesh);
  /// @param values  one for each patch
  std::vector<Irradiance> at_vertices(std::span<const Irradiance> values) const;

 private:
  struct Stencil {
    uint32_t first, count;  // into patches_ and weights_
    float reach;            // how far beyond the patches' range a value may lie, in its width
  };
  struct Builder;

  std::vector<uint32_t> group_;  // of each vertex
  std::vector<Stencil> stencils_;
  std::vector<uint32_t> patches_;
  std::vector<float> weights_;
};

/// Fills the solution's values at vertices from those of patches.
void reconstruct_vertices(Solution& solution);

}  // namespace aktina
