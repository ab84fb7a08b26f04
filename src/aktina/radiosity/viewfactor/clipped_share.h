// What a receiver sees of a source past blockers, by cutting their shadows out at points of the receiver.
#pragma once

#include <span>

#include "aktina/radiosity/viewfactor/receiver_cells.h"
#include "aktina/radiosity/viewfactor/sight_rays.h"

namespace aktina {

/// A source in front of a receiver's plane, and what stands between; coordinates of blocking polygons are those of the
/// receiver's cells.
template <class T>
struct ObstructedSource {
  std::span<const Point3d> source;
  Vec3d normal;      // of the receiver
  double tolerance;  // m
  std::span<const BlockingPolygon<T>> blocking;
  std::span<const Contour* const> contours;  // of the same blockers
};

/// The visible share of what leaves the receiver for the source: cells of the receiver are cut in four until four agree
/// with one.
/// @param wanted  error of the share
/// @param exact   where shadows of several blockers overlap at a point their union is found (slow), else they are left
///                uncertain
template <class T>
Estimate visible_share_by_clipping(const ObstructedSource<T>& between, ReceiverCells<T>& receiver, double wanted,
                                   bool exact);

}  // namespace aktina
