// The surfaces, cut into convex pieces of at most four corners and packed sixteen to a leaf, all of one plane.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/formfactor/quadrature.h"

namespace aktina {

inline constexpr size_t kLeaf = 16;

/// A convex polygon of a surface.
struct Fragment {
  Face face;
  uint32_t surface;                          // in Faces
  std::array<SurfaceSample, 4> gauss_2x2{};  // for pairs that are well apart
};

struct Leaf {
  uint32_t first, count;        // fragments
  Plane plane;                  // of all of them
  std::array<Point3d, 4> hull;  // a rectangle in it around all of them
  double largest;               // radius of a fragment, m
  Point3d centre;               // of a sphere around the hull
  double radius;
  double corners[4][3][kLeaf];  // of the fragments; triangles repeat their last one, leaves that are not full, too
};

/// Fragments in the order of the leaves.
struct Leaves {
  std::vector<Fragment> fragments;
  std::vector<Leaf> leaves;
};
Leaves make_leaves(const Faces& faces);

}  // namespace aktina
