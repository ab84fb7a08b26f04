// Sixteen points in each cell of a receiver, made once for all sources that are looked at from there.
#pragma once

#include "aktina/radiosity/viewfactor/kernels.h"
#include "aktina/radiosity/viewfactor/receiver_points.h"

namespace aktina {

/// @param unit  of lengths, m
template <class T>
PointLanes<T> point_lanes(const std::array<SurfaceSample, kLeaf>& samples, Point3d origin, double unit) {
  PointLanes<T> points;
  for (size_t k = 0; k < kLeaf; ++k) {
    points.areas[k] = T(samples[k].area / (unit * unit));
    for (int axis = 0; axis < 3; ++axis) points.x[axis][k] = T((samples[k].x[axis] - origin[axis]) / unit);
  }
  return points;
}
template <class T>
PointLanes<T> cell_points(const Cell& cell, Point3d origin, double unit) {
  return point_lanes<T>(gauss_points(cell), origin, unit);
}

template <class T>
class ReceiverCells {
 public:
  /// @param receiver  convex parts
  void set(std::span<const Contour> receiver, Point3d origin, double unit) {
    origin_ = origin, unit_ = unit;
    cells_.clear(), coarse_.clear(), fine_.clear();
    for (const Contour& part : receiver)
      for (const Cell& cell : cells_of(part)) cells_.push_back(cell);
    for (const Cell& cell : cells_) coarse_.push_back(cell_points<T>(cell, origin_, unit_));
  }
  size_t size() const { return cells_.size(); }
  const Cell& cell(size_t i) const { return cells_[i]; }
  const PointLanes<T>& coarse(size_t i) const { return coarse_[i]; }
  /// Of a quarter of a cell; made when the first is asked for.
  const PointLanes<T>& quarter(size_t i, int k) {
    if (fine_.empty())
      for (const Cell& cell : cells_)
        for (int q = 0; q < 4; ++q) fine_.push_back(cell_points<T>(cell.quarter(q), origin_, unit_));
    return fine_[4 * i + size_t(k)];
  }
  Point3d origin() const { return origin_; }
  double unit() const { return unit_; }

 private:
  Point3d origin_{0};
  double unit_ = 1;
  std::vector<Cell> cells_;
  std::vector<PointLanes<T>> coarse_, fine_;
};

}  // namespace aktina
