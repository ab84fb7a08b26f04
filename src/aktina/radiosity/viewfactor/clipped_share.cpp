#include "aktina/radiosity/viewfactor/clipped_share.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aktina/radiosity/formfactor/shadow.h"

namespace aktina {
namespace {

constexpr double kBetweenPoints = 1e-3;  // of a share, that sixteen points may miss; measured
constexpr double kSixteenPoints = 0.05;  // of a share, by which they may be wrong where a shadow's edge passes
constexpr double kBorderStrip = 0.1;     // of a cell; half of what is between its border and the outermost points
constexpr size_t kMostCells = 6000, kMostCellsExact = 60000;

template <class T>
class ClippedShare {
 public:
  ClippedShare(const ObstructedSource<T>& between, ReceiverCells<T>& receiver, double wanted, bool exact)
      : between_(between),
        receiver_(receiver),
        wanted_(wanted),
        exact_(exact),
        cells_left_(wanted < 1e-5 ? kMostCellsExact : kMostCells) {
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
    if (uniform(first) && kBetweenPoints <= wanted_) return {first.seen() / first.whole, kBetweenPoints};
    const double uncertain = kSixteenPoints + 0.5 * (first.high - first.low) / first.whole;
    if (uncertain <= 0.5 * wanted_) return {first.seen() / first.whole, uncertain};
    if (first.high - first.low > 2 * std::max(wanted_, 1e-3) * first.whole && !exact_) return {0, 1};
    const int least = wanted_ < 1e-5 ? 2 : wanted_ < 1e-3 ? 1 : 0;  // two sums may agree by chance
    for (size_t k = 0; k < receiver_.size(); ++k) {
      std::array<Shares, 4> quarters;
      for (int q = 0; q < 4; ++q)
        quarters[size_t(q)] = look_from(receiver_.cell(k).quarter(q), receiver_.quarter(k, q));
      add(receiver_.cell(k), coarse[k], quarters, least);
    }
    const double base = uniform(first) ? 0.04 * kBetweenPoints * first.whole : 0;
    refine(0.5 * wanted_ * first.whole - base);
    Shares sum;
    double error = base;
    for (const Part& part : parts_) sum += part.fine(), error += part.error;
    return {sum.seen() / sum.whole, (error + 0.5 * (sum.high - sum.low)) / sum.whole};
  }

 private:
  bool anything_hides() const {
    for (size_t k = 0; k < receiver_.size(); ++k)
      if (may_hide(receiver_.coarse(k), polygon_, between_.blocking.data(), between_.blocking.size())) return true;
    return false;
  }

  /// A cell, seen from four times as many points as before.
  struct Part {
    Cell cell;
    std::array<Shares, 4> quarters;
    double error;
    Shares fine() const {
      Shares sum;
      for (const Shares& quarter : quarters) sum += quarter;
      return sum;
    }
    bool operator<(const Part& other) const { return error < other.error; }
  };

  /// @param halvings  of the cell before its error is believed
  void add(const Cell& cell, const Shares& coarse, const std::array<Shares, 4>& quarters, int halvings) {
    Part part{cell, quarters, 0};
    if (halvings > 0) {
      quarter(part, halvings - 1);
      return;
    }
    // Of the share, for the rule that both sums follow is not exact for the unobstructed factor either.
    const Shares fine = part.fine();
    part.error = std::abs(fine.seen() - (coarse.whole > 0 ? coarse.seen() / coarse.whole * fine.whole : 0));
    if (wanted_ < 1e-3 && uniform(fine)) part.error = std::max(part.error, past_border(cell, fine));
    error_ += part.error;
    parts_.push_back(std::move(part));
    std::push_heap(parts_.begin(), parts_.end());
  }

  static bool uniform(const Shares& shares) {
    return shares.low >= (1 - 1e-5) * shares.whole || shares.high <= 1e-5 * shares.whole;
  }

  /// What may lie between the outermost points of a cell, which all see the same, and its border.
  double past_border(const Cell& cell, const Shares& within) const {
    Seen<T> seen;
    look(point_lanes<T>(border_points(cell), receiver_.origin(), receiver_.unit()), normal_, polygon_,
         between_.blocking.data(), between_.blocking.size(), seen);
    if (!(seen.all.whole > 0)) return 0;
    return kBorderStrip * std::abs(seen.all.seen() / seen.all.whole * within.whole - within.seen());
  }

  void quarter(const Part& part, int halvings) {
    for (int k = 0; k < 4; ++k) {
      const Cell smaller = part.cell.quarter(k);
      std::array<Shares, 4> quarters;
      for (int q = 0; q < 4; ++q) {
        const Cell tiny = smaller.quarter(q);
        quarters[size_t(q)] = look_from(tiny, cell_points<T>(tiny, receiver_.origin(), receiver_.unit()));
      }
      cells_left_ -= std::min<size_t>(cells_left_, 4);
      add(smaller, part.quarters[size_t(k)], quarters, halvings);
    }
  }

  /// Always the cell whose error is largest, so that cells run out where they matter least.
  void refine(double allowed) {
    while (error_ > allowed && cells_left_ > 0) {
      std::pop_heap(parts_.begin(), parts_.end());
      const Part worst = std::move(parts_.back());
      parts_.pop_back();
      error_ -= worst.error;
      quarter(worst, 0);
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
  size_t cells_left_;
  std::vector<Part> parts_;  // a heap
  double error_ = 0;         // of all of them
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
