// A convex planar face cut along segments into convex cells: a binary space partition of its plane.
#pragma once

#include <vector>

#include "aktina/base/vec.h"

namespace aktina {

using FacePolygon = std::vector<Point3d>;  // m; planar, convex

/// The part of the segment from a to b within a convex polygon of that normal, as parameters of the segment.
/// @return false where nothing longer than `tolerance`, m, is left
bool clip_segment(Point3d a, Point3d b, const FacePolygon& polygon, Vec3d normal, double tolerance, double& from,
                  double& to);

/// Corners that lie within `tolerance` of the line between their neighbours left out.
FacePolygon without_straight_corners(FacePolygon polygon, double tolerance);

/// Cut along short diagonals until no part has more than four corners.
void cut_into_quads(const FacePolygon& polygon, std::vector<FacePolygon>& parts);

class FaceCells {
 public:
  /// @param tolerance  m: what is nearer to a line lies on it
  FaceCells(FacePolygon outline, Vec3d unit_normal, double tolerance);

  /// Cuts every cell that the segment goes through, from edge to edge. In random order of disjoint segments their
  /// number grows as n log n.
  void cut(Point3d a, Point3d b);
  const std::vector<FacePolygon>& cells() const { return cells_; }

 private:
  struct Line {
    Vec3d normal;  // unit, in the plane
    double offset;
    double distance(Point3d p) const { return dot(normal, p) - offset; }
  };
  struct Node {
    Line line;
    int front = -1, back = -1;  // nodes
    int cell = -1;              // of a leaf
  };
  void split(size_t node, const Line& line);

  Vec3d normal_;
  double tolerance_;
  std::vector<Node> nodes_;
  std::vector<FacePolygon> cells_;
};

}  // namespace aktina
