#include "aktina/radiosity/viewfactor/clipped_share.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aktina/radiosity/formfactor/shadow.h"

namespace aktina {
namespace {

constexpr double kBetweenPoints = 1e-3;  // of a share, that sixteen points may miss; measured
constexpr double kSixteenPoints = 0.05;  // of a share, by which they may be wrong where a shadow's edge passes
constexpr double kBeyondPoints = 0.14;   // of a cell, on both sides of its outermost points
constexpr double kExpected = 0.5;        // of the range of shares, that a border may be beyond it
constexpr double kBorderStrip = 0.1;     // of a cell; half of what is between its border and the outermost points
constexpr size_t kMostCells = 6000, kMostCellsExact = 60000;

/// What sixteen or more points see of the source, and the range of their visible shares.
struct Sight {
  Shares all;
  double least = 1, most = 0;
  void add(double whole, double low, double high) {
    all += {whole, low, high};
    if (!(whole > 0)) return;
    least = std::min(least, 0.5 * (low + high) / whole), most = std::max(most, 0.5 * (low + high) / whole);
  }
  void operator+=(const Sight& other) {
    all += other.all;
    least = std::min(least, other.least), most = std::max(most, other.most);
  }
};

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
    std::vector<Shares> coarse(receiver_.size());
    Sight sight;
    for (size_t k = 0; k < receiver_.size(); ++k) {
      const Sight own = look_from(receiver_.cell(k), receiver_.coarse(k));
      sight += own, coarse[k] = own.all;
    }
    const Shares& first = sight.all;
    if (!(first.whole > 0)) return {1, 0};
    // Where sixteen points see no shadow or nothing else, a corner of one may still pass between them.
    if (uniform(first) && kBetweenPoints <= wanted_ && !(border_matters() && border_differs(sight)))
      return {first.seen() / first.whole, kBetweenPoints};
    const double uncertain = kSixteenPoints + 0.5 * (first.high - first.low) / first.whole;
    if (uncertain <= 0.5 * wanted_) return {first.seen() / first.whole, uncertain};
    if (first.high - first.low > 2 * std::max(wanted_, 1e-3) * first.whole && !exact_) return {0, 1};
    allowed_ = 0.5 * wanted_ * first.whole;
    const int least = wanted_ < 1e-5 ? 3 : wanted_ < 1e-3 ? 1 : 0;  // two sums may agree by chance
    for (size_t k = 0; k < receiver_.size(); ++k) {
      std::array<Sight, 4> quarters;
      for (int q = 0; q < 4; ++q)
        quarters[size_t(q)] = look_from(receiver_.cell(k).quarter(q), receiver_.quarter(k, q));
      add(receiver_.cell(k), coarse[k], quarters, least);
    }
    refine();
    Shares sum;
    double error = 0;
    for (const Part& part : parts_) sum += part.fine().all, error += part.error;
    return {sum.seen() / sum.whole, (error + 0.5 * (sum.high - sum.low)) / sum.whole};
  }

 private:
  bool anything_hides() const {
    const auto hides = [&](const PointLanes<T>& points) {
      return may_hide(points, polygon_, between_.blocking.data(), between_.blocking.size());
    };
    for (size_t k = 0; k < receiver_.size(); ++k)
      if (hides(receiver_.coarse(k)) || (border_matters() && hides(border_of(receiver_.cell(k))))) return true;
    return false;
  }

  /// Whether what is seen may jump beyond the outermost points, by more than is wanted. It does where the receiver
  /// reaches through a blocker, and then the blocker has no outline.
  bool border_matters() const {
    return wanted_ < 0.25 * kBeyondPoints &&
           std::any_of(between_.blocking.begin(), between_.blocking.end(), [](const BlockingPolygon<T>& polygon) {
             return polygon.normal[0] != 0 || polygon.normal[1] != 0 || polygon.normal[2] != 0;
           });
  }
  PointLanes<T> border_of(const Cell& cell) const {
    return point_lanes<T>(border_points(cell), receiver_.origin(), receiver_.unit());
  }

  /// A cell, seen from four times as many points as before.
  struct Part {
    Cell cell;
    std::array<Sight, 4> quarters;
    double error;
    Sight fine() const {
      Sight sum;
      for (const Sight& quarter : quarters) sum += quarter;
      return sum;
    }
    bool operator<(const Part& other) const { return error < other.error; }
  };

  /// @param halvings  of the cell before its error is believed
  void add(const Cell& cell, const Shares& coarse, const std::array<Sight, 4>& quarters, int halvings) {
    Part part{cell, quarters, 0};
    if (halvings > 0) {
      quarter(part, halvings - 1);
      return;
    }
    // Of the share, for the rule that both sums follow is not exact for the unobstructed factor either.
    const Sight sight = part.fine();
    const Shares& fine = sight.all;
    part.error = std::abs(fine.seen() - (coarse.whole > 0 ? coarse.seen() / coarse.whole * fine.whole : 0));
    if ((wanted_ < 1e-3 || border_matters()) && part.error <= allowed_)
      part.error = std::max(part.error, past_border(cell, sight));
    error_ += part.error;
    parts_.push_back(std::move(part));
    std::push_heap(parts_.begin(), parts_.end());
  }

  static bool uniform(const Shares& shares) {
    return shares.low >= (1 - 1e-5) * shares.whole || shares.high <= 1e-5 * shares.whole;
  }

  /// What may lie between the outermost points of a cell and its border, where more or less is seen there than the
  /// points' shares let expect.
  double past_border(const Cell& cell, const Sight& within) const {
    Seen<T> seen;
    look(border_of(cell), normal_, polygon_, between_.blocking.data(), between_.blocking.size(), seen);
    const double slack = kExpected * (within.most - within.least) + 1e-6;
    double excess = 0;
    for (size_t k = 0; k < kLeaf; ++k)
      if (const double whole = double(seen.whole[k]); whole > 0)
        excess += std::max({0.0, double(seen.low[k]) / whole - within.most - slack,
                            within.least - slack - double(seen.high[k]) / whole});
    return kBorderStrip * excess / kLeaf * within.all.whole;
  }

  bool border_differs(const Sight& within) const {
    for (size_t k = 0; k < receiver_.size(); ++k)
      if (past_border(receiver_.cell(k), within) > kBetweenPoints * within.all.whole) return true;
    return false;
  }

  void quarter(const Part& part, int halvings) {
    for (int k = 0; k < 4; ++k) {
      const Cell smaller = part.cell.quarter(k);
      std::array<Sight, 4> quarters;
      for (int q = 0; q < 4; ++q) {
        const Cell tiny = smaller.quarter(q);
        quarters[size_t(q)] = look_from(tiny, cell_points<T>(tiny, receiver_.origin(), receiver_.unit()));
      }
      cells_left_ -= std::min<size_t>(cells_left_, 4);
      add(smaller, part.quarters[size_t(k)].all, quarters, halvings);
    }
  }

  /// Always the cell whose error is largest, so that cells run out where they matter least.
  void refine() {
    while (error_ > allowed_ && cells_left_ > 0) {
      std::pop_heap(parts_.begin(), parts_.end());
      const Part worst = std::move(parts_.back());
      parts_.pop_back();
      error_ -= worst.error;
      quarter(worst, 0);
    }
  }

  Sight look_from(const Cell& cell, const PointLanes<T>& points) const {
    Seen<T> seen;
    look(points, normal_, polygon_, between_.blocking.data(), between_.blocking.size(), seen);
    Sight sight;
    for (size_t k = 0; k < kLeaf; ++k) {
      const double whole = double(seen.whole[k]);
      double low = double(seen.low[k]), high = double(seen.high[k]);
      if (exact_ && high - low > 1e-6 * whole) {  // shadows overlap
        const SurfaceSample sample = gauss_points(cell)[k];
        const double unit = receiver_.unit();
        low = high = visible_from(sample.x) * sample.area / (unit * unit);
      }
      sight.add(whole, low, high);
    }
    return sight;
  }

  double visible_from(Point3d x) const {
    const Contour source(between_.source.begin(), between_.source.end());
    std::vector<Contour> occluders;
    for (const Contour* contour : between_.contours) occluders.push_back(*contour);
    return visible_part(x, between_.normal, {&source, 1}, occluders, between_.tolerance).visible;
  }

  const ObstructedSource<T>& between_;
  ReceiverCells<T>& receiver_;
  double wanted_, allowed_ = 0;  // of the share; of all cells' errors
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
