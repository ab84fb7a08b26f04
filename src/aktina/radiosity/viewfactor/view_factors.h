// View-factor matrices of whole scenes: what thermal and lighting engineers call the form factors between surfaces.
// A surface may be several planar pieces: an object, all of one material, a polygon that is not quite planar.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "aktina/base/progress.h"
#include "aktina/base/warnings.h"
#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/viewfactor/large_array.h"

namespace aktina {

/// Pieces see and hide each other; occluders only hide. Fronts take part, both sides hide.
struct ViewFactorScene {
  std::vector<Polygon> pieces;
  std::vector<uint32_t> owners;    // of each piece: its surface
  std::vector<std::string> names;  // of each surface
  std::vector<Polygon> occluders;
  std::vector<double> emissivities;    // of each surface, where the file has them
  std::vector<double> transmittances;  // of each piece: what goes straight on through it; empty: nothing anywhere
  std::string source;                  // file it came from, for reports
  Warnings warnings;

  size_t surfaces() const { return names.size(); }
};

/// N x N in compressed rows: F_ij for k in [starts[i], starts[i + 1]) is factors[k] with j = columns[k], ascending.
/// A_i F_ij is computed once for both directions: reciprocity holds to rounding by construction.
struct ViewFactors {
  std::vector<std::string> names;
  std::vector<double> areas;  // m^2
  std::vector<uint64_t> starts{0};
  LargeArray<uint32_t> columns;
  LargeArray<double> factors;
  LargeArray<float> errors;  // estimate of each factor's absolute error
  /// Of each surface, the mean over its area; empty where nothing passes. What goes on through a surface has arrived at
  /// it, too, and arrives again behind it: in a closed enclosure the sum of F_ij (1 - transmittance_j) is 1.
  std::vector<double> transmittances;

  /// By surface: 1 where its row is complete; empty where all are. What is missing lies between two that are not.
  std::vector<uint8_t> complete;

  // Of what the integration found before a factor was held between 0 and its unobstructed value; see Certificate.
  double largest_excess = 0;  // above the unobstructed factor
  uint64_t held = 0;          // pairs

  size_t size() const { return areas.size(); }
  double row_sum(size_t i) const;       // of what stays: F_ij (1 - transmittance_j)
  double at(size_t i, size_t j) const;  // 0 where nothing is stored
  bool known(size_t i, size_t j) const { return complete.empty() || complete[i] || complete[j]; }
};

struct ViewFactorOptions {
  double target_error = 1e-4;  // of each factor; 1e-8 .. 0.1
  uint64_t most_bytes = 0;     // of memory; 0: three quarters of the machine's
  /// A folder for files that hold a matrix for which memory is too small, while it is there; empty: it is refused.
  std::filesystem::path scratch{};
  /// Called before the work with what it will take of that folder, where it needs it.
  std::function<void(double bytes)> foreseen{};
};

/// @throws Error bad_input (no surface; a polygon as make_face() refuses it), limit (memory, foreseen),
/// bad_param; cancelled (before a row was complete; else those that are come back)
ViewFactors view_factors(const ViewFactorScene& scene, const ViewFactorOptions& options, Progress* progress = nullptr);

}  // namespace aktina
