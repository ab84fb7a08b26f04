// Vertex normals from the facets around a vertex.
#pragma once

#include <span>

#include "aktina/base/method.h"
#include "aktina/base/vec.h"

namespace aktina {

/// One facet at a vertex Q: the edges from Q to its next and its previous corner, counter-clockwise seen from the
/// front.
struct FacetCorner {
  Vec3d next, previous;  // m
};

/// What a facet adds to the normal of its vertex: its direction times the method's weight; 0 for a degenerate facet.
using FacetWeighting = Vec3d (*)(const FacetCorner& corner);

/// Unit normal of a vertex from its fan of facets, in any order; 0 where the sum vanishes (no facets, only degenerate
/// ones, or facets that cancel each other).
Vec3d vertex_normal(FacetWeighting weighting, std::span<const FacetCorner> fan);

std::span<const Method<FacetWeighting>* const> normals();
/// By angle: the one that does not depend on how the facets are cut.
FacetWeighting default_weighting();

}  // namespace aktina
