// Exchange areas between the fragments of two leaves.
#pragma once

#include "aktina/radiosity/viewfactor/blocking_view.h"
#include "aktina/radiosity/viewfactor/clipped_share.h"
#include "aktina/radiosity/viewfactor/exchange.h"

namespace aktina {

/// What all pairs share.
struct PairSetting {
  const Leaves& leaves;
  const BlockerTree& blockers;
  const SightRays& rays;
  double target, tolerance, unit;  // unit: the scene's size, m; the kernels count in it
};

struct HeldPairs {
  double largest_excess = 0;
  uint64_t count = 0;
};

template <class T>
class PairExchange {
 public:
  explicit PairExchange(const PairSetting& setting) : setting_(setting) {}

  /// @param a, b  leaves, the first of lower number;  @param view  of the two, which face each other
  /// @param result  gains what they exchange, where that is anything
  void run(uint32_t a, uint32_t b, const LeafView& view, ExchangeStore::Writer& store,
           std::vector<LeafExchange>& result, HeldPairs& held);

 private:
  const Fragment& fragment(const Leaf& leaf, uint32_t k) const { return setting_.leaves.fragments[leaf.first + k]; }
  bool is_cut(const Leaf& leaf, const Plane& plane) const;
  double clearance(const Leaf& leaf, const LeafView& view) const;
  void choose_sides(const Leaf& a, const Leaf& b, const LeafView& view);
  void prepare_sources();
  void prepare_blockers(const LeafView& view);
  void receive(uint32_t r);
  uint32_t unhidden(uint32_t r);
  int order(const Face& receiver, const Face& source) const;
  bool all_apart(const Face& receiver) const;
  void unobstructed(uint32_t r, uint32_t sources);
  void by_points(uint32_t r, int n);
  void find_between(uint32_t r, uint32_t s);
  void set_cells(uint32_t r);
  Estimate past_blockers(uint32_t r, uint32_t s, Estimate open);
  void keep(uint32_t r, uint32_t s, Estimate e);

  const PairSetting& setting_;
  const Leaf *receiver_ = nullptr, *source_ = nullptr;
  bool forward_ = true;  // the receiver is the first leaf
  bool receiver_cut_ = false, source_cut_ = false, crowded_ = false;
  HeldPairs* held_ = nullptr;
  Place place_;
  std::array<std::span<const Point3d>, kLeaf> parts_;  // of the sources, in front of the receiver
  std::array<Contour, kLeaf> cut_parts_;
  uint32_t source_mask_ = 0;
  double least_source_ = 0, most_source_ = 0;  // areas
  SourceLanes<T> lanes_;
  T normal_[3];
  std::vector<BlockingView<T>> blockers_;
  size_t blocker_count_ = 0;
  // Of one receiver.
  std::span<const Point3d> part_;  // in front of the source's plane
  Contour cut_part_;
  std::vector<Contour> pieces_;
  ReceiverCells<T> cells_;
  bool cells_set_ = false;
  double areas_[kLeaf], errors_[kLeaf];
  std::vector<uint32_t> lanes_between_;  // of each blocker: sources that it may hide
  // Of one pair.
  std::vector<BlockingPolygon<T>> between_;
  std::vector<const Contour*> contours_between_;
  size_t blockers_between_ = 0;
  std::vector<SurfaceSample> samples_;
  std::vector<ReceiverPoint<T>> points_;
  std::array<Exchange, kLeaf * kLeaf> found_;
  uint32_t found_count_ = 0;
};

}  // namespace aktina
