// Exchange areas A_i F_ij between all planar pieces of a scene, each pair once.
#pragma once

#include <vector>

#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/viewfactor/view_factors.h"

namespace aktina {

/// One pair of pieces that see each other.
struct Exchange {
  uint32_t other;  // the piece of higher number
  float error;     // estimate, m^2
  double area;     // A_i F_ij, m^2
};

struct Exchanges {
  std::vector<std::vector<Exchange>> rows;  // of each piece, by ascending `other`
  double largest_excess = 0;                // of a factor above its unobstructed value
  uint64_t held = 0;
};

/// @param target_error  of F_ij and of F_ji
Exchanges exchanges(const Faces& faces, double target_error, Progress* progress);

}  // namespace aktina
