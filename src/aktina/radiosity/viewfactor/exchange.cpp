#include "aktina/radiosity/viewfactor/exchange.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/viewfactor/leaf_tree.h"
#include "aktina/radiosity/viewfactor/pair_exchange.h"

namespace aktina {
namespace {

constexpr double kSinglePrecision = 1e-5;  // targets from here on are met by floats
constexpr uint64_t kSampled = 4000;        // pairs of leaves

double size_of(const std::vector<Leaf>& leaves) {
  double size = 0;
  for (const Leaf& leaf : leaves) size = std::max(size, length(leaf.centre - leaves[0].centre) + leaf.radius);
  return size;
}

}  // namespace

struct ExchangeFinder::Parts {
  Leaves leaves;
  LeafTree tree;
  BlockerTree blockers;
  SightRays rays;
  PairSetting setting;
  bool single;

  Parts(const Faces& faces, double target, std::vector<Blocker> found, Leaves made)
      : leaves(std::move(made)),
        tree(leaves.leaves),
        blockers(std::move(found)),
        rays(faces, blockers.size() > 1),
        setting{leaves, blockers, rays, target, 0, size_of(leaves.leaves)},
        single(target >= kSinglePrecision) {
    setting.tolerance = 1e-9 * setting.unit + 4e-15 * length(leaves.leaves[0].centre);
  }
};

ExchangeFinder::ExchangeFinder(const Faces& faces, double target)
    : parts_(std::make_unique<Parts>(faces, target, find_blockers(faces, target >= kSinglePrecision ? 3e-6 : 1e-10),
                                     make_leaves(faces))) {}
ExchangeFinder::~ExchangeFinder() = default;

const Leaves& ExchangeFinder::leaves() const { return parts_->leaves; }

ExchangeFinder::Forecast ExchangeFinder::forecast() const {
  const std::vector<Leaf>& leaves = parts_->leaves.leaves;
  const uint64_t n = leaves.size(), all = n * (n - 1) / 2;
  LeafView view;
  Forecast sum;
  uint64_t looked = 0;
  const auto look = [&](uint64_t a, uint64_t b) {
    ++looked;
    look_between(leaves[a], leaves[b], parts_->blockers, parts_->setting.tolerance, view);
    const double pairs = double(leaves[a].count) * double(leaves[b].count);
    if (!view.facing || view.blocked) return;
    sum.pairs += pairs;
    if (view.crowded || !view.candidates.empty()) sum.obstructed += pairs;
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
  const double scale = looked > 0 ? double(all) / double(looked) : 0;
  return {sum.pairs * scale, sum.obstructed * scale};
}

namespace {

/// How long a row that is begun may go on once the work is stopped: most are complete by then.
class Grace {
 public:
  explicit Grace(const Progress* progress) : progress_(progress) {}
  bool over() {
    if (!progress_ || !progress_->cancelled()) return false;
    const auto now = std::chrono::steady_clock::now();
    if (!stopped_) stopped_ = now;
    return now - *stopped_ > std::chrono::seconds(3);
  }

 private:
  const Progress* progress_;
  std::optional<std::chrono::steady_clock::time_point> stopped_;
};

template <class T>
void find_all(const PairSetting& setting, const LeafTree& tree, Exchanges& result, Progress* progress) {
  const std::vector<Leaf>& leaves = setting.leaves.leaves;
  std::vector<HeldPairs> held(leaves.size());
  std::vector<uint8_t> done(leaves.size(), 0);
  std::atomic<uint32_t> next{0};  // in their order, so that the first ones are complete where it is stopped
  parallel_for(leaves.size(), 1, [&](size_t begin, size_t end) {
    PairExchange<T> pair(setting);
    PairExchange<double> precise(setting);
    ExchangeStore::Writer store(*result.store);
    LeafView view;
    Grace grace(progress);
    for (size_t taken = begin; taken < end; ++taken) {
      if (progress && progress->cancelled()) return;
      const uint32_t a = next.fetch_add(1, std::memory_order_relaxed);
      tree.visit(leaves[a], a + 1, setting.blockers, setting.tolerance, [&](uint32_t b) {
        if (grace.over()) return;
        look_between(leaves[a], leaves[b], setting.blockers, setting.tolerance, view);
        if (!view.facing || view.blocked) return;
        if (view.entered)
          precise.run(a, b, view, store, result.lists[a], held[a]);
        else
          pair.run(a, b, view, store, result.lists[a], held[a]);
      });
      if (grace.over()) return;  // perhaps in its middle
      done[a] = 1;
      if (progress) progress->advance();
    }
  });
  while (result.complete < done.size() && done[result.complete]) ++result.complete;
  for (size_t a = result.complete; a < leaves.size(); ++a) result.lists[a].clear();
  for (size_t a = 0; a < result.complete; ++a) {
    result.largest_excess = std::max(result.largest_excess, held[a].largest_excess);
    result.held += held[a].count;
  }
}

}  // namespace

Exchanges ExchangeFinder::find(const std::filesystem::path& folder, Progress* progress) const {
  Exchanges result;
  result.store = std::make_unique<ExchangeStore>(folder);
  result.lists.resize(parts_->leaves.leaves.size());
  parts_->single ? find_all<float>(parts_->setting, parts_->tree, result, progress)
                 : find_all<double>(parts_->setting, parts_->tree, result, progress);
  return result;
}

}  // namespace aktina
