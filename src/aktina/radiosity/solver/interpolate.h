// Irradiance of coarse patches -> irradiance of the patches in them, smooth where the surface is.
#pragma once

#include <span>
#include <vector>

#include "aktina/radiosity/solver/coarse_patches.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// A linear fit through neighbours, nearer ones weigh more: those that face about the same way and that can be seen
/// over the surface, so that nothing is carried through a wall that stands on it. Within the range of the neighbours,
/// or beyond it by a quarter.
class CoarseInterpolation {
 public:
  /// The arguments must outlive this.
  CoarseInterpolation(const CoarsePatches& patches, const Sides& sides, const Visibility& visibility);

  /// Adds to values of sides. Sides that are buried in their patch get nothing.
  /// @param coarse  three bands, by coarse patch
  void add(std::span<const double> coarse, const std::vector<float>& open, std::vector<Rgb>& fine) const;

 private:
  void find_neighbours();
  double size(size_t patch) const;
  Rgb at(size_t side, std::span<const double> coarse) const;

  const CoarsePatches& patches_;
  const Sides& sides_;
  const Visibility& visibility_;
  std::vector<uint32_t> first_, neighbours_;
};

}  // namespace aktina
