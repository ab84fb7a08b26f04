// How light gets from one node to another: the kernel cos cos / (pi r^2), sampled and taken apart into the functions of
// a basis, and the share of rays that pass.
#pragma once

#include <array>
#include <span>

#include "aktina/radiosity/solver/hierarchy/basis.h"
#include "aktina/radiosity/solver/hierarchy/surface_tree.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// As if nothing were in between.
struct NodeExchange {
  float factor = 0;  // mean form factor from the receiving to the sending node
  float spread = 0;  // how far it is from what a link makes of it: an error of form factor
};

class Transport {
 public:
  static constexpr size_t kMostCoefficients = 81;
  using Coefficients = std::array<float, kMostCoefficients>;

  /// How the spread is measured: the difference between the largest and the smallest form factor of places on the
  /// nodes (Hanrahan), or between the kernel and what the basis makes of it in between (Gortler).
  enum class Spread { range, interpolation };

  /// `basis` must outlive this.
  Transport(const Basis& basis, Spread spread) : basis_(basis), spread_(spread) {}

  /// Coefficient [i * sender's functions + j] takes function j of the sender to function i of the receiver.
  /// @param coefficients  of as many; may be null where the basis is constant: the factor is all there is
  NodeExchange sample(const TreePatch& receiver, const TreePatch& sender, float* coefficients) const;

  /// The same where they are near each other: quarters of quarters, then Lambert's formula, for the kernel is singular
  /// where they touch.
  void sample_near(const TreePatch& receiver, const TreePatch& sender, float* coefficients) const;
  /// Nearer than samples of the kernel are good for.
  static bool near(const TreePatch& receiver, const TreePatch& sender);

 private:
  void project(const TreePatch& receiver, const TreePatch& sender, const float* kernel, float* coefficients) const;
  void collect(const TreePatch& receiver, const TreePatch& sender, int depth, float* coefficients) const;
  float interpolation_error(const TreePatch& receiver, const TreePatch& sender, const float* kernel) const;

  const Basis& basis_;
  Spread spread_;
};

/// Whether one is wholly behind the other, so that no light can pass.
bool turned_away(const TreePatch& a, const TreePatch& b);

/// A share of rays between places spread over two nodes, weighted by the kernel: the sum of weights (returned), and,
/// after flush(), that of those which pass, added to the sum of `owner`.
float look_between(const TreePatch& receiver, const TreePatch& sender, int rays, uint32_t seed,
                   const Visibility& visibility, VisibilityQueue& queue, uint32_t owner);

}  // namespace aktina
