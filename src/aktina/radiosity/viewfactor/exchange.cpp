#include "aktina/radiosity/viewfactor/exchange.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/formfactor/polygon_to_polygon.h"
#include "aktina/radiosity/viewfactor/clipped_share.h"
#include "aktina/radiosity/viewfactor/kernels.h"
#include "aktina/radiosity/viewfactor/leaf_pair.h"
#include "aktina/radiosity/viewfactor/receiver_points.h"
#include "aktina/radiosity/viewfactor/sight_rays.h"

namespace aktina {
namespace {

constexpr double kSinglePrecision = 1e-5;  // targets from here on are met by floats
constexpr size_t kMostClipped = 24;        // blockers between two fragments beyond which rays are faster
constexpr double kRayError = 2.5e-3;       // of a share, that rays come down to

/// What all pairs share.
struct Setting {
  const Faces& faces;
  const Leaves& leaves;
  BlockerTree blockers;
  double target, tolerance, unit;  // unit: the scene's size, m; the kernels count in it
  SightRays rays;
};

struct Counts {
  double largest_excess = 0;
  uint64_t held = 0;
};

double power(double x, int n) {
  double result = 1;
  for (; n > 0; --n) result *= x;
  return result;
}

template <class T>
class LeafPair {
 public:
  explicit LeafPair(const Setting& setting) : setting_(setting) {}

  /// @param view  of the two leaves, which face each other
  void run(uint32_t a, uint32_t b, LeafView& view, Exchanges& result, Counts& counts) {
    a_ = &setting_.leaves.leaves[a], b_ = &setting_.leaves.leaves[b];
    counts_ = &counts;
    candidates_.swap(view.candidates), crowded_ = view.crowded;
    heights_of_receiver_.clear(), heights_of_source_.clear(), blocking_.clear(), contours_.clear();
    choose_sides();
    prepare_sources();
    if (source_mask_ == 0) return;
    if (!crowded_) prepare_blockers();
    const bool small = a_->count * b_->count <= kLeaf;
    if (!small) block_ = std::make_unique<ExchangeBlock>(), block_->a = a, block_->b = b;
    entries_ = &result.entries[a];
    bool any = false;
    for (uint32_t r = 0; r < receiver_->count; ++r) any = receive(r) || any;
    if (any && block_) result.blocks[a].push_back(std::move(block_));
    block_.reset();
  }

 private:
  const Fragment& fragment(const Leaf& leaf, uint32_t k) const { return setting_.leaves.fragments[leaf.first + k]; }

  bool is_cut(const Leaf& leaf, const Plane& plane) const {
    for (uint32_t k = 0; k < leaf.count; ++k)
      for (const Point3d& p : fragment(leaf, k).face.vertices)
        if (plane.height(p) < -setting_.tolerance) return true;
    return false;
  }

  double clearance(const Leaf& leaf) const {
    double nearest = INFINITY;
    for (const uint32_t k : candidates_)
      for (const Contour& face : setting_.blockers[k].faces)
        for (const Point3d& p : face) nearest = std::min(nearest, leaf.plane.height(p));
    return nearest;
  }

  /// A leaf that the other's plane cuts is the source, whose polygons can be cut for all points at once. Else the one
  /// nearer to what hides it is, for there the shadow's edge is sharp; else the larger.
  void choose_sides() {
    const bool a_cut = is_cut(*a_, b_->plane), b_cut = is_cut(*b_, a_->plane);
    bool a_receives = a_->largest <= b_->largest;
    if (a_cut != b_cut)
      a_receives = b_cut;
    else if (!candidates_.empty())
      if (const double from_a = clearance(*a_), from_b = clearance(*b_); from_a != from_b) a_receives = from_a > from_b;
    receiver_ = a_receives ? a_ : b_, source_ = a_receives ? b_ : a_;
    receiver_cut_ = a_receives ? a_cut : b_cut, source_cut_ = a_receives ? b_cut : a_cut;
    origin_ = source_->centre;
  }

  Contour in_front(const Contour& contour, const Plane& plane, bool cut) const {
    return cut ? clip(contour, plane, setting_.tolerance) : contour;
  }

  void store(T (&to)[3], Point3d p) const {
    for (int k = 0; k < 3; ++k) to[k] = T((p[k] - origin_[k]) / setting_.unit);
  }

  void prepare_sources() {
    lanes_.count = 3, source_mask_ = 0;
    for (Contour& part : parts_) part.clear();
    for (uint32_t s = 0; s < source_->count; ++s) {
      parts_[s] = in_front(fragment(*source_, s).face.vertices, receiver_->plane, source_cut_);
      if (parts_[s].empty()) continue;
      source_mask_ |= 1U << s;
      lanes_.count = std::max(lanes_.count, int(parts_[s].size()));
    }
    const Point3d far = source_->centre + (2 * source_->radius + 1) * receiver_->plane.normal;
    for (size_t s = 0; s < kLeaf; ++s)
      for (int k = 0; k < lanes_.count; ++k) {
        const Contour& part = parts_[s];
        const Point3d p = part.empty() ? far : part[std::min(size_t(k), part.size() - 1)];
        for (int axis = 0; axis < 3; ++axis) lanes_.corners[k][axis][s] = T((p[axis] - origin_[axis]) / setting_.unit);
      }
    for (int k = 0; k < 3; ++k) normal_[k] = T(receiver_->plane.normal[k]);
  }

  void prepare_blockers() {
    for (const uint32_t k : candidates_) {
      const Blocker& blocker = setting_.blockers[k];
      heights_of_receiver_.emplace_back(setting_.leaves, *receiver_, blocker, setting_.tolerance);
      heights_of_source_.emplace_back(setting_.leaves, *source_, blocker, setting_.tolerance);
      std::vector<BlockingPolygon<T>>& polygons = blocking_.emplace_back();
      contours_.emplace_back();
      for (const Contour& face : blocker.faces) {
        const Contour part = clip(clip(face, lifted(receiver_->plane), 0), lifted(source_->plane), 0);
        if (part.size() > kMostBlocking) continue;
        polygons.push_back(blocking_polygon(part, face, blocker));
        if (!part.empty()) contours_.back().push_back(part);
      }
      if (!polygons.empty()) polygons[0].first = true;
    }
  }

  /// Edges that lie in the planes of receiver or source would coincide with those of the source.
  Plane lifted(const Plane& plane) const {
    return {plane.point + (sizeof(T) == 4 ? 1e-6 : 1e-11) * setting_.unit * plane.normal, plane.normal};
  }

  /// @param face  that `part` (empty where nothing of it is in between) was cut from
  BlockingPolygon<T> blocking_polygon(const Contour& part, const Contour& face, const Blocker& blocker) const {
    BlockingPolygon<T> polygon{};
    polygon.count = int(part.size());
    polygon.two_sided = !blocker.closed, polygon.closed = blocker.closed;
    Vec3d normal(0);
    for (size_t k = 0; k < part.size(); ++k) store(polygon.corners[k], part[k]);
    for (size_t k = 2; k < face.size(); ++k) normal += cross(face[k - 1] - face[0], face[k] - face[0]);
    normal = normalize(normal);
    for (int k = 0; k < 3; ++k) polygon.normal[k] = T(normal[k]);
    polygon.offset = T(dot(normal, face[0] - origin_) / setting_.unit);
    return polygon;
  }

  /// One fragment against all sources.
  bool receive(uint32_t r) {
    const Fragment& receiver = fragment(*receiver_, r);
    const Contour part = in_front(receiver.face.vertices, source_->plane, receiver_cut_);
    if (part.empty()) return false;
    double areas[kLeaf] = {}, errors[kLeaf] = {};
    unobstructed(receiver.face, part, areas, errors);
    bool any = false;
    for (uint32_t s = 0; s < source_->count; ++s) {
      if (!(source_mask_ >> s & 1) || !(areas[s] > 0)) continue;
      const Estimate e = past_blockers(r, part, s, {areas[s], errors[s]});
      any = any || e.value > 0;
      keep(r, s, e);
    }
    return any;
  }

  void keep(uint32_t r, uint32_t s, Estimate e) {
    const bool forward = receiver_ == a_;
    const uint32_t a = forward ? r : s, b = forward ? s : r;
    if (block_)
      block_->area[a][b] = e.value, block_->error[a][b] = float(e.error);
    else if (e.value > 0)
      entries_->push_back({a_->first + a, b_->first + b, float(e.error), e.value});
  }

  /// How many Gauss points on each axis a pair needs; 0: it is too near for any. The error of n points falls as the
  /// 2n-th power of size over distance; measured on squares: 0.02 F of it.
  int order(const Face& receiver, const Face& source) const {
    const double distance = length(receiver.centre - source.centre), sizes = receiver.radius + source.radius;
    if (distance < 2 * sizes) return 0;
    const double ratio = receiver.radius / distance, square = ratio * ratio;
    const double f = std::min(receiver.area, source.area) / (kPi * distance * distance) * 0.02;
    const double allowed = 0.02 * setting_.target * std::min(1.0, source.area / receiver.area);
    if (f * square * square <= allowed && distance > 3 * sizes) return 2;
    return f * square * square * square * square <= allowed ? 4 : f * power(square, 6) <= allowed ? 6 : 0;
  }

  void unobstructed(const Face& receiver, const Contour& part, double (&areas)[kLeaf], double (&errors)[kLeaf]) {
    int n = 0;
    uint32_t near = 0;
    int orders[kLeaf] = {};
    for (uint32_t s = 0; s < source_->count; ++s) {
      if (!(source_mask_ >> s & 1)) continue;
      orders[s] = order(receiver, fragment(*source_, s).face);
      if (orders[s] == 0) near |= 1U << s;
      n = std::max(n, orders[s]);
    }
    if (n > 0) by_points(part, n, areas);
    for (uint32_t s = 0; s < source_->count; ++s) {
      if (!(source_mask_ >> s & 1)) continue;
      const Face& source = fragment(*source_, s).face;
      if (near >> s & 1) {
        areas[s] = exchange_area(receiver, source, part, parts_[s]);
        errors[s] = 1e-13 * std::min(receiver.area, source.area);
      } else {
        const double ratio = receiver.radius / length(receiver.centre - source.centre);
        errors[s] = areas[s] * (0.02 * power(ratio * ratio, n) + (sizeof(T) == 4 ? 3e-6 : 1e-12));
      }
    }
  }

  void by_points(const Contour& part, int n, double (&areas)[kLeaf]) {
    samples_.clear();
    add_gauss_points(part, n, samples_);
    points_.resize(samples_.size());
    for (size_t k = 0; k < samples_.size(); ++k) {
      store(points_[k].x, samples_[k].x);
      points_[k].weight = T(samples_[k].area);
    }
    alignas(64) T sums[kLeaf] = {};
    add_lanes(lanes_, points_.data(), points_.size(), normal_, sums);
    for (size_t s = 0; s < kLeaf; ++s) areas[s] = std::max(0.0, double(sums[s]));
  }

  /// What may hide source s from receiver r. False where one blocker hides all of it.
  bool find_between(uint32_t r, uint32_t s) {
    between_.clear(), contours_between_.clear(), blockers_between_ = 0;
    for (size_t k = 0; k < candidates_.size(); ++k) {
      const FragmentHeights &of_r = heights_of_receiver_[k], &of_s = heights_of_source_[k];
      if (of_r.outside(r) & of_s.outside(s)) continue;
      if (blocks_all(
              of_r.corners(r), of_s.corners(s), setting_.blockers[candidates_[k]], setting_.tolerance,
              [&](size_t corner, size_t bound) { return of_r.height(r, corner, bound); },
              [&](size_t corner, size_t bound) { return of_s.height(s, corner, bound); }))
        return false;
      if (++blockers_between_ > kMostClipped) return true;
      between_.insert(between_.end(), blocking_[k].begin(), blocking_[k].end());
      contours_between_.insert(contours_between_.end(), contours_[k].begin(), contours_[k].end());
    }
    return true;
  }

  Estimate past_blockers(uint32_t r, const Contour& part, uint32_t s, Estimate open) {
    if (!crowded_) {
      if (!find_between(r, s)) return {0, 0};
      if (between_.empty()) return open;
    }
    const double smaller = std::min(fragment(*receiver_, r).face.area, fragment(*source_, s).face.area);
    const double wanted = 0.25 * setting_.target * smaller / open.value;  // of the visible share
    Estimate share{0, 1};
    if (!crowded_ && blockers_between_ <= kMostClipped)
      share = visible_share_by_clipping<T>(
          {parts_[s], receiver_->plane.normal, origin_, setting_.unit, setting_.tolerance, between_, contours_between_},
          part, wanted, wanted < kRayError);
    if (share.error > wanted) {
      const Estimate sent = setting_.rays.visible_share(part, receiver_->plane.normal, parts_[s], source_->plane.normal,
                                                        wanted, hash_combine(receiver_->first + r, source_->first + s));
      if (sent.error < share.error) share = sent;
    }
    if (share.value > 1) {
      ++counts_->held;
      counts_->largest_excess = std::max(counts_->largest_excess, open.value * (share.value - 1) / smaller);
      share.value = 1;
    }
    return {open.value * share.value, open.error + open.value * share.error};
  }

  const Setting& setting_;
  const Leaf *a_ = nullptr, *b_ = nullptr;
  std::vector<uint32_t> candidates_;  // blockers that may stand between
  Counts* counts_ = nullptr;
  std::unique_ptr<ExchangeBlock> block_;  // where they go, or
  std::vector<ExchangeEntry>* entries_ = nullptr;
  const Leaf *receiver_ = nullptr, *source_ = nullptr;
  bool receiver_cut_ = false, source_cut_ = false;
  Point3d origin_{0};
  std::array<Contour, kLeaf> parts_;  // of the sources, in front of the receiver
  uint32_t source_mask_ = 0;
  SourceLanes<T> lanes_;
  T normal_[3];
  std::vector<FragmentHeights> heights_of_receiver_, heights_of_source_;  // by candidate
  std::vector<std::vector<BlockingPolygon<T>>> blocking_;                 // by candidate
  std::vector<std::vector<Contour>> contours_;                            // the same
  bool crowded_ = false;                                                  // too many candidates to look at
  // Of one pair.
  std::vector<BlockingPolygon<T>> between_;
  std::vector<Contour> contours_between_;
  size_t blockers_between_ = 0;
  std::vector<SurfaceSample> samples_;
  std::vector<ReceiverPoint<T>> points_;
};

template <class T>
void run_all(const Setting& setting, Exchanges& result, Progress* progress) {
  const size_t n = setting.leaves.leaves.size();
  std::vector<Counts> counts(n);
  parallel_for(n, 1, [&](size_t begin, size_t end) {
    LeafPair<T> pair(setting);
    LeafView view;
    for (size_t a = begin; a < end; ++a) {
      if (progress) progress->throw_if_cancelled();
      for (size_t b = a + 1; b < n; ++b) {
        look_between(setting.leaves.leaves[a], setting.leaves.leaves[b], setting.blockers, setting.tolerance, view);
        if (view.facing && !view.blocked) pair.run(uint32_t(a), uint32_t(b), view, result, counts[a]);
      }
      if (progress) progress->advance();
    }
  });
  for (const Counts& c : counts) {
    result.largest_excess = std::max(result.largest_excess, c.largest_excess);
    result.held += c.held;
  }
}

constexpr uint64_t kSampled = 20000;  // pairs of leaves
// A block's share of a pair, and both directions in compressed rows, once by themselves and once in the matrix.
constexpr double kBytesPerPair = 12 + 4 * 16;

/// Pairs of fragments that see something of each other: all leaves where they are few, else a sample of them.
double visible_pairs(const Setting& setting) {
  const uint64_t n = setting.leaves.leaves.size(), all = n * (n - 1) / 2;
  LeafView view;
  double pairs = 0;
  uint64_t looked = 0;
  const auto look = [&](uint64_t a, uint64_t b) {
    const Leaf &one = setting.leaves.leaves[a], &other = setting.leaves.leaves[b];
    ++looked;
    look_between(one, other, setting.blockers, setting.tolerance, view);
    if (view.facing && !view.blocked) pairs += double(one.count) * double(other.count);
  };
  if (all <= kSampled) {
    for (uint64_t a = 0; a < n; ++a)
      for (uint64_t b = a + 1; b < n; ++b) look(a, b);
  } else {
    for (uint32_t k = 0; k < kSampled; ++k) {
      const uint64_t a = hash_combine(k, 1) % n, b = hash_combine(k, 2) % n;
      if (a != b) look(a, b);
    }
  }
  return looked > 0 ? pairs / double(looked) * double(all) : 0;
}

void check_memory(const Setting& setting, double allowed) {
  const double needed = kBytesPerPair * visible_pairs(setting);
  if (needed <= allowed) return;
  const size_t n = setting.leaves.fragments.size();
  throw Error(Code::limit, "surfaces",
              fmt::format("the matrix of {} will take about {:.2g} GB, more than the {:.2g} GB allowed", n,
                          needed / 1e9, allowed / 1e9),
              fmt::format("about {} would fit", size_t(std::sqrt(allowed / needed) * double(n))));
}

}  // namespace

Exchanges exchanges(const Faces& faces, double target_error, double allowed_bytes, Progress* progress) {
  Exchanges result;
  result.leaves = make_leaves(faces);
  result.blocks.resize(result.leaves.leaves.size()), result.entries.resize(result.leaves.leaves.size());
  double size = 0;
  for (const Leaf& leaf : result.leaves.leaves)
    size = std::max(size, length(leaf.centre - result.leaves.leaves[0].centre) + leaf.radius);
  const bool single = target_error >= kSinglePrecision;
  const double tolerance = 1e-9 * size + 4e-15 * length(result.leaves.leaves[0].centre);
  std::vector<Blocker> blockers = find_blockers(faces, single ? 3e-6 : 1e-10);
  const bool shadows_overlap = blockers.size() > 1;
  const Setting setting{faces,     result.leaves, BlockerTree(std::move(blockers)), target_error,
                        tolerance, size,          SightRays(faces, shadows_overlap)};
  check_memory(setting, allowed_bytes);
  if (progress) progress->begin("view factors", "leaves", result.leaves.leaves.size());
  single ? run_all<float>(setting, result, progress) : run_all<double>(setting, result, progress);
  return result;
}

}  // namespace aktina
