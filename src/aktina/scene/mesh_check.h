// What is odd about a mesh: counted, not mended.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "aktina/base/vec.h"

namespace aktina {

/// Vertices in exactly the same place are one. Degenerate and duplicate triangles are counted and left out of the rest.
struct MeshCheck {
  uint64_t triangles = 0;
  uint64_t degenerate = 0;  // without area, or with a corner twice
  uint64_t duplicate = 0;   // the same three vertices again, whichever way round
  uint64_t edges = 0;
  uint64_t boundary_edges = 0;      // of one triangle only
  uint64_t non_manifold_edges = 0;  // of more than two
  uint64_t inconsistent_edges = 0;  // whose two triangles face opposite sides
  uint64_t pinched_vertices = 0;    // where surfaces touch in a point only (a bowtie)
  uint64_t t_junctions = 0;         // vertices of the boundary that lie within another edge of it
  uint64_t pieces = 0;              // parts connected over edges
  double area = 0;                  // m^2
  double volume = 0;                // m^3, enclosed; negative where it is inside out. Has a meaning where closed only
  bool closed() const { return edges > 0 && boundary_edges == 0 && non_manifold_edges == 0; }
};

MeshCheck check_mesh(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles);

}  // namespace aktina
