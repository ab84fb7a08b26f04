// Where light may leak: pieces of geometry that end just short of each other, and surfaces that go through each other.
#pragma once

#include <string>
#include <vector>

#include "aktina/scene/scene.h"

namespace aktina {

/// An edge that runs along a surface of another piece without touching it: light slips through between them.
struct Gap {
  Point3 place;              // m, middle of the edge
  double width, length;      // m
  uint32_t instance, other;  // of the edge and of the surface
};

struct Leaks {
  double most_width = 0;  // m: gaps narrower than this were looked for
  uint64_t gaps = 0;
  double gap_length = 0;       // m, of all these edges
  std::vector<Gap> worst;      // up to ten: those with the largest opening, width times length
  uint64_t crossed_faces = 0;  // faces that others touch or cross within their outline: partly buried
  double crossing_length = 0;  // m, of these lines
  bool complete = true;        // false: not examined, too many faces, or too many near each other
};

/// Scenes of more triangles are not examined: each would take about 600 bytes, and 6 s a million.
inline constexpr uint64_t kMostLeakTriangles = 200'000;

/// @param scene  without analytic primitives
/// @param most_width  m; 0: a thousandth of the scene's diagonal. What is nearer than kTouch touches: rays start as far
///                    off, so no light gets between.
/// Pieces are what shared vertices connect; within one piece nothing counts as a gap.
Leaks find_leaks(const Scene& scene, double most_width = 0);

}  // namespace aktina
