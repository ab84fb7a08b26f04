#include "aktina/radiosity/viewfactor/clipped_share.h"

#include <algorithm>
#include <cmath>

#include "aktina/radiosity/formfactor/shadow.h"

namespace aktina {
namespace {

constexpr double kBetweenPoints = 1e-3;  // of a share, that sixteen points may miss; measured
constexpr double kSixteenPoints = 0.05;  // of a share, by which they may be wrong where a shadow's edge passes
constexpr int kMostHalvings = 8;
constexpr size_t kMostCells = 6000;

template <class T>
class ClippedShare {
 public:
  ClippedShare(const ObstructedSource<T>& between, ReceiverCells<T>& receiver, double wanted, bool exact)
      : between_(between), receiver_(receiver), wanted_(wanted), exact_(exact) {
    polygon_.count = int(between.source.size());
    for (int k = 0; k < polygon_.count; ++k)
      for (int axis = 0; axis < 3; ++axis)
        polygon_.corners[k][axis] = T((between.source[size_t(k)][axis] - receiver.origin()[axis]) / receiver.unit());
    for (int axis = 0; axis < 3; ++axis) normal_[axis] = T(between.normal[axis]);
  }

  Estimate run() {
    if (kBetweenPoints <= wanted_ && !anything_hides()) return {1, kBetweenPoints};
    std::array<Shares, 2> coarse;
    Shares first;
    for (size_t k = 0; k < receiver_.size(); ++k)
      first += coarse[k] = look_from(receiver_.cell(k), receiver_.coarse(k));
    if (!(first.whole > 0)) return {1, 0};
    // Where sixteen points see no shadow or nothing else, a corner of one may still pass between them.
    const bool uniform = first.low >= (1 - 1e-5) * first.whole || first.high <= 1e-5 * first.whole;
    if (uniform && kBetweenPoints <= wanted_) return {first.seen() / first.whole, kBetweenPoints};
    const double uncertain = kSixteenPoints + 0.5 * (first.high - first.low) / first.whole;
    if (uncertain <= 0.5 * wanted_) return {first.seen() / first.whole, uncertain};
    if (first.high - first.low > 2 * std::max(wanted_, 1e-3) * first.whole && !exact_) return {0, 1};
    least_halvings_ = wanted_ < 1e-5 ? 2 : wanted_ < 1e-3 ? 1 : 0;  // two sums may agree by chance
    if (uniform) error_ = 0.04 * kBetweenPoints * first.whole;
    for (size_t k = 0; k < receiver_.size(); ++k) {
      std::array<Shares, 4> quarters;
      for (int q = 0; q < 4; ++q)
        quarters[size_t(q)] = look_from(receiver_.cell(k).quarter(q), receiver_.quarter(k, q));
      refine(receiver_.cell(k), coarse[k], quarters, 0.5 * wanted_ * first.whole, 0);
    }
    return {sum_.seen() / sum_.whole, (error_ + 0.5 * (sum_.high - sum_.low)) / sum_.whole};
  }

 private:
  bool anything_hides() const {
    for (size_t k = 0; k < receiver_.size(); ++k)
      if (may_hide(receiver_.coarse(k), polygon_, between_.blocking.data(), between_.blocking.size())) return true;
    return false;
  }

  void refine(const Cell& cell, const Shares& coarse, const std::array<Shares, 4>& quarters, double allowed,
              int halvings) {
    Shares fine;
    for (const Shares& quarter : quarters) fine += quarter;
    cells_left_ -= std::min<size_t>(cells_left_, 4);
    // Of the share, for the rule that both sums follow is not exact for the unobstructed factor either.
    const double difference =
        std::abs(fine.seen() - (coarse.whole > 0 ? coarse.seen() / coarse.whole * fine.whole : 0));
    if ((difference <= allowed && halvings >= least_halvings_) || halvings == kMostHalvings || cells_left_ == 0) {
      sum_ += fine, error_ += difference;
      return;
    }
    for (int k = 0; k < 4; ++k) {
      const Cell part = cell.quarter(k);
      std::array<Shares, 4> smaller;
      for (int q = 0; q < 4; ++q) {
        const Cell tiny = part.quarter(q);
        smaller[size_t(q)] = look_from(tiny, cell_points<T>(tiny, receiver_.origin(), receiver_.unit()));
      }
      refine(part, quarters[size_t(k)], smaller, 0.5 * allowed, halvings + 1);
    }
  }

  Shares look_from(const Cell& cell, const PointLanes<T>& points) const {
    Seen<T> seen;
    look(points, normal_, polygon_, between_.blocking.data(), between_.blocking.size(), seen);
    if (!exact_ || !(seen.all.high - seen.all.low > 1e-6 * seen.all.whole)) return seen.all;
    Shares shares;
    for (size_t k = 0; k < kLeaf; ++k) {
      const double whole = double(seen.whole[k]);
      double low = double(seen.low[k]), high = double(seen.high[k]);
      if (high - low > 1e-6 * whole) {
        const SurfaceSample sample = gauss_points(cell)[k];
        const double unit = receiver_.unit();
        low = high = visible_from(sample.x) * sample.area / (unit * unit);
      }
      shares += {whole, low, high};
    }
    return shares;
  }

  double visible_from(Point3d x) const {
    const Contour source(between_.source.begin(), between_.source.end());
    std::vector<Contour> occluders;
    for (const Contour* contour : between_.contours) occluders.push_back(*contour);
    return visible_part(x, between_.normal, {&source, 1}, occluders, between_.tolerance).visible;
  }

  const ObstructedSource<T>& between_;
  ReceiverCells<T>& receiver_;
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
Estimate visible_share_by_clipping(const ObstructedSource<T>& between, ReceiverCells<T>& receiver, double wanted,
                                   bool exact) {
  return ClippedShare<T>(between, receiver, wanted, exact).run();
}
template Estimate visible_share_by_clipping<float>(const ObstructedSource<float>&, ReceiverCells<float>&, double, bool);
template Estimate visible_share_by_clipping<double>(const ObstructedSource<double>&, ReceiverCells<double>&, double,
                                                    bool);

}  // namespace aktina
