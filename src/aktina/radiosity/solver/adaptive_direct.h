// Direct light on a mesh that is refined where that light changes fast.
#pragma once

#include "aktina/radiosity/solver/direct_sources.h"

namespace aktina {

/// Computes direct light, splits patches where it changes by more than refinement.gradient, computes it for the new
/// ones, and so on until refinement.depth.
/// @param mesh  the first one; afterwards the last
DirectLight refine_by_direct_light(const Scene& scene, const Visibility& visibility, const Refinement& refinement,
                                   const RadiosityOptions& options, const MeshOptions& mesh_options, PatchMesh& mesh,
                                   KeptDirectLight& kept, Progress* progress);

/// By patch: whether light within it, reconstructed at its corners, differs by more than `most` of the light there or
/// of the mean of all patches, whichever is more.
/// @param light  of each side, lx
std::vector<uint8_t> steep_patches(const Sides& sides, std::span<const Rgb> light, double most);

}  // namespace aktina
