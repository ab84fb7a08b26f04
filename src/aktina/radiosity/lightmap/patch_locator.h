// A point on a surface -> the patch of a solution that it lies in.
#pragma once

#include <array>
#include <vector>

#include "aktina/radiosity/solution.h"

namespace aktina {

/// Between the vertices of a patch: weights add up to 1. Bilinear within quadrilaterals.
struct PatchPlace {
  std::array<uint32_t, 4> vertices{};
  std::array<float, 4> weights{};
  template <class Quantity>
  Rgb blend(const std::vector<Quantity>& values) const {
    Rgb sum;
    for (size_t k = 0; k < 4; ++k) sum += values[vertices[k]].v * weights[k];
    return sum;
  }
};

class PatchLocator {
 public:
  /// `mesh` must outlive this.
  explicit PatchLocator(const PatchMesh& mesh);

  /// @param x      on the instance's surface, m, world; front: unit normal of its front side there
  /// @param guess  patch that is looked at first; becomes the patch that was found
  PatchPlace find(uint32_t instance, Point3 x, Vec3 front, uint32_t& guess) const;

 private:
  struct Found {
    float squared_distance = kInfinity;
    PatchPlace place;
  };
  struct Grid {
    uint32_t first = 0, end = 0;  // patches
    Bounds bounds;
    float per_metre = 1;                  // cells
    std::vector<uint32_t> starts, items;  // of buckets
  };
  void build(Grid& grid) const;
  uint32_t bucket(const Grid& grid, glm::ivec3 cell) const;
  glm::ivec3 cell_of(const Grid& grid, Point3 p) const;
  Found look_at(uint32_t patch, Point3 x, Vec3 front) const;
  Bounds around(uint32_t patch) const;

  const PatchMesh& mesh_;
  std::vector<Grid> grids_;        // of instances with patches
  std::vector<uint32_t> grid_of_;  // of each instance
};

}  // namespace aktina
