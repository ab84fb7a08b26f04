// One blocker as it stands between two leaves: cut by their planes, and its outline as a receiver sees it.
#pragma once

#include <optional>

#include "aktina/radiosity/viewfactor/kernels.h"
#include "aktina/radiosity/viewfactor/leaf_pair.h"

namespace aktina {

/// Of the coordinates that kernels see.
struct Place {
  Point3d origin{0};
  double unit = 1;  // m
};

template <class T>
class BlockingView {
 public:
  LaneHeights of_receiver, of_source;

  void set(const Blocker& blocker, const Leaf& receiver, const Leaf& source, const Place& place, double tolerance);
  const Blocker& blocker() const { return *blocker_; }

  /// What hides sources from a receiver: one outline where all of the receiver sees the same faces of the blocker, else
  /// all faces. Valid until the next call.
  std::span<const BlockingPolygon<T>> seen_from(size_t receiver_lane);
  /// Whether a receiver is on both sides of a face's plane.
  bool is_straddled_by(size_t receiver_lane) const { return !fronts(receiver_lane); }
  /// The faces, cut.
  const std::vector<Contour>& contours();

 private:
  struct Outline {
    uint32_t faces;
    bool usable;
    BlockingPolygon<T> polygon;
  };
  void cut();
  /// Faces whose front all of the receiver sees, as bits; nothing where it sees some of a face's.
  std::optional<uint32_t> fronts(size_t receiver_lane) const;
  const Outline& outline(uint32_t faces);
  Contour outline_of(uint32_t faces) const;
  void place(const Contour& contour, BlockingPolygon<T>& polygon) const;
  Plane lifted(const Plane& plane) const;

  const Blocker* blocker_ = nullptr;
  const Leaf *receiver_ = nullptr, *source_ = nullptr;
  Place place_;
  float tolerance_ = 0;
  bool cut_ = false;
  std::vector<Contour> parts_;  // of each face; empty where nothing of it is in between
  std::vector<Contour> contours_;
  std::vector<BlockingPolygon<T>> polygons_;
  std::vector<Outline> outlines_;
};

}  // namespace aktina
