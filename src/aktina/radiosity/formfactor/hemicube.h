// What the cells of a hemicube count.
#pragma once

#include <cstddef>
#include <vector>

namespace aktina {

/// Delta form factors of all cells, kept by symmetry: a quarter of the top, half of half a side.
class DeltaFormFactors {
 public:
  /// @param resolution  cells along an edge of the cube; even
  explicit DeltaFormFactors(int resolution);

  /// Cell (x, y) of the top; 0 <= x, y < resolution.
  double top(int x, int y) const { return top_[index(x, y)]; }
  /// Cell of a side; row 0 is the uppermost, row resolution / 2 - 1 the last above the horizon.
  double side(int x, int y) const { return side_[index(x, y)]; }
  double total() const;      // of the whole hemicube: 1 + O(resolution^-2)
  double top_share() const;  // of the top

 private:
  static double sum(const std::vector<double>& cells);
  /// By the distance from the middle of the face.
  size_t index(int x, int y) const {
    const int half = resolution_ / 2;
    const int i = x < half ? half - 1 - x : x - half, j = y < half ? half - 1 - y : y - half;
    return size_t(j) * size_t(half) + size_t(i);
  }

  int resolution_;
  std::vector<double> top_, side_;  // rows from the middle outwards
};

}  // namespace aktina
