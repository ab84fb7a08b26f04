#include "aktina/radiosity/viewfactor/pair_exchange.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "aktina/base/random.h"
#include "aktina/radiosity/formfactor/polygon_to_polygon.h"
#include "aktina/radiosity/viewfactor/receiver_cut.h"

namespace aktina {
namespace {

constexpr size_t kMostClipped = 24;   // blockers between two fragments beyond which rays are faster
constexpr size_t kFewClipped = 4;     // whose union is cut out even where rays might do, if they leave doubt
constexpr double kRayError = 2.5e-3;  // of a share, that rays come down to

double power(double x, int n) {
  double result = 1;
  for (; n > 0; --n) result *= x;
  return result;
}

}  // namespace

template <class T>
void PairExchange<T>::run(uint32_t a, uint32_t b, const LeafView& view, ExchangeStore::Writer& store,
                          std::vector<LeafExchange>& result, HeldPairs& held) {
  held_ = &held, crowded_ = view.crowded, blocker_count_ = 0, found_count_ = 0;
  choose_sides(setting_.leaves.leaves[a], setting_.leaves.leaves[b], view);
  prepare_sources();
  if (source_mask_ == 0) return;
  if (!crowded_) prepare_blockers(view);
  for (uint32_t r = 0; r < receiver_->count; ++r) receive(r);
  if (found_count_ == 0) return;
  result.push_back({a, b, store.keep({found_.data(), found_count_})});
}

template <class T>
bool PairExchange<T>::is_cut(const Leaf& leaf, const Plane& plane) const {
  if (std::all_of(leaf.hull.begin(), leaf.hull.end(),
                  [&](Point3d p) { return plane.height(p) >= -setting_.tolerance; }))
    return false;
  for (uint32_t k = 0; k < leaf.count; ++k)
    for (const Point3d& p : fragment(leaf, k).face.vertices)
      if (plane.height(p) < -setting_.tolerance) return true;
  return false;
}

template <class T>
double PairExchange<T>::clearance(const Leaf& leaf, const LeafView& view) const {
  double nearest = INFINITY;
  for (const uint32_t k : view.candidates)
    for (const Contour& face : setting_.blockers[k].faces)
      for (const Point3d& p : face) nearest = std::min(nearest, leaf.plane.height(p));
  return nearest;
}

/// A leaf that the other's plane cuts is the source, whose polygons can be cut for all points at once. Else the one
/// nearer to what hides it is, for there the shadow's edge is sharp; else the larger.
template <class T>
void PairExchange<T>::choose_sides(const Leaf& a, const Leaf& b, const LeafView& view) {
  const bool a_cut = is_cut(a, b.plane), b_cut = is_cut(b, a.plane);
  forward_ = a.largest <= b.largest;
  if (a_cut != b_cut)
    forward_ = b_cut;
  else if (!view.candidates.empty())
    if (const double from_a = clearance(a, view), from_b = clearance(b, view); from_a != from_b)
      forward_ = from_a > from_b;
  receiver_ = forward_ ? &a : &b, source_ = forward_ ? &b : &a;
  receiver_cut_ = forward_ ? a_cut : b_cut, source_cut_ = forward_ ? b_cut : a_cut;
  place_ = {source_->centre, setting_.unit};
}

template <class T>
void PairExchange<T>::prepare_sources() {
  lanes_.count = 3, source_mask_ = 0, least_source_ = INFINITY, most_source_ = 0;
  for (uint32_t s = 0; s < source_->count; ++s) {
    const Face& face = fragment(*source_, s).face;
    parts_[s] = face.vertices;
    if (source_cut_) parts_[s] = cut_parts_[s] = clip(face.vertices, receiver_->plane, setting_.tolerance);
    if (parts_[s].empty()) continue;
    source_mask_ |= 1U << s;
    lanes_.count = std::max(lanes_.count, int(parts_[s].size()));
    least_source_ = std::min(least_source_, face.area), most_source_ = std::max(most_source_, face.area);
  }
  const Point3d far = source_->centre + (2 * source_->radius + 1) * receiver_->plane.normal;
  const double scale = 1 / setting_.unit;
  for (size_t s = 0; s < kLeaf; ++s)
    for (int k = 0; k < lanes_.count; ++k) {
      const bool used = source_mask_ >> s & 1;
      const Point3d p = used ? parts_[s][std::min(size_t(k), parts_[s].size() - 1)] : far;
      for (int axis = 0; axis < 3; ++axis) lanes_.corners[k][axis][s] = T((p[axis] - place_.origin[axis]) * scale);
    }
  for (int k = 0; k < 3; ++k) normal_[k] = T(receiver_->plane.normal[k]);
}

template <class T>
void PairExchange<T>::prepare_blockers(const LeafView& view) {
  blocker_count_ = view.candidates.size();
  if (blockers_.size() < blocker_count_) blockers_.resize(blocker_count_);
  lanes_between_.resize(blocker_count_);
  for (size_t k = 0; k < blocker_count_; ++k)
    blockers_[k].set(setting_.blockers[view.candidates[k]], *receiver_, *source_, place_, setting_.tolerance);
}

/// One fragment against all sources.
template <class T>
void PairExchange<T>::receive(uint32_t r) {
  part_ = fragment(*receiver_, r).face.vertices;
  if (receiver_cut_) part_ = cut_part_ = clip(part_, source_->plane, setting_.tolerance);
  if (part_.empty()) return;
  const uint32_t seen = unhidden(r);
  if (seen == 0) return;
  cells_set_ = false;
  unobstructed(r, seen);
  for (uint32_t left = seen; left != 0; left &= left - 1) {
    const auto s = uint32_t(std::countr_zero(left));
    if (!(areas_[s] > 0)) continue;
    if (!crowded_ && blocker_count_ == 0) {
      keep(r, s, {areas_[s], errors_[s]});
      continue;
    }
    const Estimate e = past_blockers(r, s, {areas_[s], errors_[s]});
    if (e.value > 0) keep(r, s, e);
  }
}

/// Sources that no single blocker hides wholly; sets those which each one may hide in part.
template <class T>
uint32_t PairExchange<T>::unhidden(uint32_t r) {
  uint32_t seen = source_mask_;
  for (size_t k = 0; k < blocker_count_ && seen != 0; ++k) {
    const BlockingView<T>& view = blockers_[k];
    const uint32_t outside = view.of_receiver.outside(r);
    uint32_t lanes = 0;
    for (uint32_t s = 0; s < source_->count; ++s) lanes |= uint32_t((outside & view.of_source.outside(s)) == 0) << s;
    lanes &= seen;
    if (lanes != 0) {
      const Blocker& blocker = view.blocker();
      seen &= ~blocked_lanes(view.of_receiver.data() + r, view.of_source.data(), blocker.bounds.size(),
                             blocker.closed ? blocker.bounds.size() : 2, float(setting_.tolerance), lanes);
    }
    lanes_between_[k] = lanes;
  }
  return seen;
}

template <class T>
void PairExchange<T>::keep(uint32_t r, uint32_t s, Estimate e) {
  found_[found_count_++] = {uint8_t(forward_ ? r : s), uint8_t(forward_ ? s : r), float(e.error), e.value};
}

/// How many Gauss points on each axis a pair needs; 0: it is too near for any. The error of n points falls as the
/// 2n-th power of size over distance; measured on squares: 0.02 F of it.
template <class T>
int PairExchange<T>::order(const Face& receiver, const Face& source) const {
  const double distance = length(receiver.centre - source.centre), sizes = receiver.radius + source.radius;
  if (distance < 1.4 * sizes) return 0;
  const double ratio = receiver.radius / distance, square = ratio * ratio;
  const double f = std::min(receiver.area, source.area) / (kPi * distance * distance) * 0.02;
  const double allowed = 0.02 * setting_.target * std::min(1.0, source.area / receiver.area);
  if (f * square * square <= allowed && distance > 3 * sizes) return 2;
  if (f * power(square, 4) <= allowed && distance > 2 * sizes) return 4;
  return f * power(square, 6) <= allowed ? 6 : 0;
}

/// Whether two points on each axis are certainly enough for all sources.
template <class T>
bool PairExchange<T>::all_apart(const Face& receiver) const {
  const double distance = length(receiver.centre - source_->centre) - source_->radius;
  if (distance <= 3 * (receiver.radius + source_->largest)) return false;
  const double square = receiver.radius * receiver.radius / (distance * distance);
  const double f = std::min(receiver.area, most_source_) / (kPi * distance * distance) * 0.02;
  return f * square * square <= 0.02 * setting_.target * std::min(1.0, least_source_ / receiver.area);
}

template <class T>
void PairExchange<T>::unobstructed(uint32_t r, uint32_t sources) {
  const Face& receiver = fragment(*receiver_, r).face;
  const double precision = sizeof(T) == 4 ? 3e-6 : 1e-12;
  if (all_apart(receiver)) {
    by_points(r, 2);
    const double ratio = receiver.radius / (length(receiver.centre - source_->centre) - source_->radius);
    for (uint32_t s = 0; s < source_->count; ++s) errors_[s] = areas_[s] * (0.02 * power(ratio, 4) + precision);
    return;
  }
  int n = 0, orders[kLeaf] = {};
  for (uint32_t s = 0; s < source_->count; ++s)
    if (sources >> s & 1) n = std::max(n, orders[s] = order(receiver, fragment(*source_, s).face));
  if (n > 0) by_points(r, n);
  for (uint32_t s = 0; s < source_->count; ++s) {
    if (!(sources >> s & 1)) continue;
    const Face& source = fragment(*source_, s).face;
    if (orders[s] == 0) {
      areas_[s] = exchange_area(receiver, source, part_, parts_[s]);
      errors_[s] = 1e-13 * std::min(receiver.area, source.area);
    } else {
      const double ratio = receiver.radius / length(receiver.centre - source.centre);
      errors_[s] = areas_[s] * (0.02 * power(ratio * ratio, n) + precision);
    }
  }
}

template <class T>
void PairExchange<T>::by_points(uint32_t r, int n) {
  std::span<const SurfaceSample> samples = fragment(*receiver_, r).gauss_2x2;
  if (n != 2 || receiver_cut_) {
    samples_.clear();
    add_gauss_points(part_, n, samples_);
    samples = samples_;
  }
  points_.resize(samples.size());
  const double scale = 1 / setting_.unit;
  for (size_t k = 0; k < samples.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) points_[k].x[axis] = T((samples[k].x[axis] - place_.origin[axis]) * scale);
    points_[k].weight = T(samples[k].area);
  }
  alignas(64) T sums[kLeaf] = {};
  add_lanes(lanes_, points_.data(), points_.size(), normal_, sums);
  for (size_t s = 0; s < kLeaf; ++s) areas_[s] = std::max(0.0, double(sums[s]));
}

template <class T>
void PairExchange<T>::find_between(uint32_t r, uint32_t s) {
  between_.clear(), contours_between_.clear(), blockers_between_ = 0;
  for (size_t k = 0; k < blocker_count_; ++k) {
    if (!(lanes_between_[k] >> s & 1)) continue;
    if (++blockers_between_ > kMostClipped) return;
    const auto polygons = blockers_[k].seen_from(r);
    between_.insert(between_.end(), polygons.begin(), polygons.end());
    for (const Contour& contour : blockers_[k].contours()) contours_between_.push_back(&contour);
  }
}

template <class T>
void PairExchange<T>::set_cells(uint32_t r) {
  cells_set_ = true;
  pieces_.assign(1, Contour(part_.begin(), part_.end()));
  for (size_t k = 0; k < blocker_count_; ++k)
    if (blockers_[k].is_straddled_by(r))
      cut_where_met(blockers_[k].blocker(), receiver_->plane, setting_.tolerance, pieces_);
  cells_.set(pieces_, place_.origin, place_.unit);
}

template <class T>
Estimate PairExchange<T>::past_blockers(uint32_t r, uint32_t s, Estimate open) {
  if (!crowded_) {
    find_between(r, s);
    if (between_.empty()) return open;
  }
  const double smaller = std::min(fragment(*receiver_, r).face.area, fragment(*source_, s).face.area);
  const double wanted = 0.25 * setting_.target * smaller / open.value;  // of the visible share
  Estimate share{0, 1};
  const auto improve = [&](Estimate other) {
    if (other.error < share.error) share = other;
  };
  const bool clippable = !crowded_ && blockers_between_ <= kMostClipped;
  const auto clipped = [&](bool exact) {
    if (!cells_set_) set_cells(r);
    return visible_share_by_clipping<T>(
        {parts_[s], receiver_->plane.normal, setting_.tolerance, between_, contours_between_}, cells_, wanted, exact);
  };
  if (clippable) improve(clipped(wanted < kRayError));
  if (share.error > wanted)
    improve(setting_.rays.visible_share({part_, receiver_->plane.normal}, {parts_[s], source_->plane.normal},
                                        open.value, wanted, hash_combine(receiver_->first + r, source_->first + s)));
  if (clippable && blockers_between_ <= kFewClipped && share.error > wanted && wanted >= kRayError)
    improve(clipped(true));
  if (share.value > 1) {
    ++held_->count;
    held_->largest_excess = std::max(held_->largest_excess, open.value * (share.value - 1) / smaller);
    share.value = 1;
  }
  return {open.value * share.value, open.error + open.value * share.error};
}

template class PairExchange<float>;
template class PairExchange<double>;

}  // namespace aktina
