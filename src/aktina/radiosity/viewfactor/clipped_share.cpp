#include "aktina/radiosity/viewfactor/clipped_share.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/shadow.h"
#include "aktina/radiosity/viewfactor/receiver_points.h"

namespace aktina {
namespace {

constexpr double kBetweenPoints = 1e-3;  // of a share, that sixteen points may miss; measured
constexpr double kSixteenPoints = 0.05;  // of a share, by which they may be wrong where a shadow's edge passes
constexpr int kMostHalvings = 8;
constexpr size_t kMostCells = 6000;

/// Integrals over a cell: unobstructed; what is certainly seen; what may be seen.
struct Shares {
  double whole = 0, low = 0, high = 0;
  double seen() const { return 0.5 * (low + high); }
  void operator+=(const Shares& other) { whole += other.whole, low += other.low, high += other.high; }
};

template <class T>
class ClippedShare {
 public:
  ClippedShare(const ObstructedSource<T>& between, double wanted, bool exact)
      : between_(between), wanted_(wanted), exact_(exact) {
    polygon_.count = int(between.source.size());
    for (int k = 0; k < polygon_.count; ++k)
      for (int axis = 0; axis < 3; ++axis) polygon_.corners[k][axis] = placed(between.source[size_t(k)], axis);
    for (int axis = 0; axis < 3; ++axis) normal_[axis] = T(between.normal[axis]);
  }

  Estimate of(const Contour& receiver) {
    const std::vector<Cell> cells = cells_of(receiver);
    std::vector<Shares> coarse;
    Shares first;
    for (const Cell& cell : cells) first += coarse.emplace_back(look_from(cell));
    if (!(first.whole > 0)) return {1, 0};
    // Where sixteen points see no shadow or nothing else, a corner of one may still pass between them.
    const bool uniform = first.low >= (1 - 1e-5) * first.whole || first.high <= 1e-5 * first.whole;
    if (uniform && kBetweenPoints <= wanted_) return {first.seen() / first.whole, kBetweenPoints};
    const double uncertain = kSixteenPoints + 0.5 * (first.high - first.low) / first.whole;
    if (uncertain <= 0.5 * wanted_) return {first.seen() / first.whole, uncertain};
    if (first.high - first.low > 2 * std::max(wanted_, 1e-3) * first.whole && !exact_) return {0, 1};
    least_halvings_ = wanted_ < 1e-5 ? 2 : wanted_ < 1e-3 ? 1 : 0;  // two sums may agree by chance
    if (uniform) error_ = 0.04 * kBetweenPoints * first.whole;
    for (size_t k = 0; k < cells.size(); ++k) refine(cells[k], coarse[k], 0.5 * wanted_ * first.whole, 0);
    return {sum_.seen() / sum_.whole, (error_ + 0.5 * (sum_.high - sum_.low)) / sum_.whole};
  }

 private:
  T placed(const Point3d& p, int axis) const { return T((p[axis] - between_.origin[axis]) / between_.unit); }

  void refine(const Cell& cell, const Shares& coarse, double allowed, int halvings) {
    std::array<Shares, 4> quarters;
    Shares fine;
    for (int k = 0; k < 4; ++k) fine += quarters[size_t(k)] = look_from(cell.quarter(k));
    cells_left_ -= std::min<size_t>(cells_left_, 4);
    // Of the share, for the rule that both sums follow is not exact for the unobstructed factor either.
    const double difference =
        std::abs(fine.seen() - (coarse.whole > 0 ? coarse.seen() / coarse.whole * fine.whole : 0));
    if ((difference <= allowed && halvings >= least_halvings_) || halvings == kMostHalvings || cells_left_ == 0) {
      sum_ += fine, error_ += difference;
      return;
    }
    for (int k = 0; k < 4; ++k) refine(cell.quarter(k), quarters[size_t(k)], 0.5 * allowed, halvings + 1);
  }

  Shares look_from(const Cell& cell) const {
    const std::array<SurfaceSample, kLeaf> samples = gauss_points(cell);
    PointLanes<T> lanes;
    for (size_t k = 0; k < kLeaf; ++k)
      for (int axis = 0; axis < 3; ++axis) lanes.x[axis][k] = placed(samples[k].x, axis);
    Seen<T> seen;
    look(lanes, normal_, polygon_, between_.blocking.data(), between_.blocking.size(), seen);
    Shares shares;
    for (size_t k = 0; k < kLeaf; ++k) {
      const double whole = double(seen.whole[k]), hidden = double(seen.hidden[k]), most = double(seen.most[k]);
      if (!(whole > 0)) continue;
      double low = std::max(0.0, whole - hidden), high = std::max(0.0, whole - most);
      if (exact_ && high - low > 1e-6 * whole)
        low = high =
            visible_part(samples[k].x, between_.normal, {&between_.source, 1}, between_.contours, between_.tolerance)
                .visible;
      shares += {samples[k].area * whole, samples[k].area * low, samples[k].area * high};
    }
    return shares;
  }

  const ObstructedSource<T>& between_;
  double wanted_;
  bool exact_;
  SourcePolygon<T> polygon_{};
  T normal_[3];
  size_t cells_left_ = kMostCells;
  int least_halvings_ = 0;
  Shares sum_;
  double error_ = 0;
};

}  // namespace

template <class T>
Estimate visible_share_by_clipping(const ObstructedSource<T>& between, const Contour& receiver, double wanted,
                                   bool exact) {
  return ClippedShare<T>(between, wanted, exact).of(receiver);
}
template Estimate visible_share_by_clipping<float>(const ObstructedSource<float>&, const Contour&, double, bool);
template Estimate visible_share_by_clipping<double>(const ObstructedSource<double>&, const Contour&, double, bool);

}  // namespace aktina
