// Exchange areas A_i F_ij between all surfaces of a scene, each pair once.
#pragma once

#include <memory>
#include <vector>

#include "aktina/radiosity/viewfactor/leaves.h"
#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

/// Between the fragments of two leaves, the first of lower number.
struct ExchangeBlock {
  uint32_t a, b;              // leaves
  double area[kLeaf][kLeaf];  // A_i F_ij, m^2
  float error[kLeaf][kLeaf];  // estimates, m^2
};

/// The same of one pair of fragments, where leaves are too small for blocks.
struct ExchangeEntry {
  uint32_t a, b;  // fragments
  float error;
  double area;
};

struct Exchanges {
  Leaves leaves;
  std::vector<std::vector<std::unique_ptr<ExchangeBlock>>> blocks;  // of each leaf: with those above; none where all 0
  std::vector<std::vector<ExchangeEntry>> entries;                  // of each leaf: with those above; none that is 0
  double largest_excess = 0;  // of a factor above its unobstructed value, before it was held to that
  uint64_t held = 0;          // pairs
};

/// @param target_error   of F_ij and of F_ji
/// @param allowed_bytes  of memory for what is found and the matrix that is made of it
/// @throws Error limit (from a sample of the leaves, before memory is taken), cancelled
Exchanges exchanges(const Faces& faces, double target_error, double allowed_bytes, Progress* progress);

}  // namespace aktina
