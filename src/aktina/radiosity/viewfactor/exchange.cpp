#include "aktina/radiosity/viewfactor/exchange.h"

#include <algorithm>
#include <atomic>
#include <cmath>

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

template <class T>
void find_all(const PairSetting& setting, const LeafTree& tree, std::span<const uint32_t> asked, Exchanges& result,
              Progress* progress) {
  const std::vector<Leaf>& leaves = setting.leaves.leaves;
  const bool all = asked.size() == leaves.size();
  std::vector<bool> is_asked(leaves.size(), false);
  for (const uint32_t a : asked) is_asked[a] = true;
  std::vector<HeldPairs> held(asked.size());
  std::vector<uint8_t> done(asked.size(), 0);
  std::atomic<size_t> next{0};  // in their order, so that the first ones are complete where it is stopped
  parallel_for(asked.size(), 1, [&](size_t begin, size_t end) {
    PairExchange<T> pair(setting);
    PairExchange<double> precise(setting);
    LeafView view;
    for (size_t taken = begin; taken < end; ++taken) {
      if (progress && progress->cancelled()) return;
      const size_t k = next.fetch_add(1, std::memory_order_relaxed);
      const uint32_t a = asked[k];
      tree.visit(leaves[a], all ? a + 1 : 0, setting.blockers, setting.tolerance, [&](uint32_t b) {
        if (b == a || (b < a && is_asked[b])) return;
        const auto [low, high] = std::minmax(a, b);
        look_between(leaves[low], leaves[high], setting.blockers, setting.tolerance, view);
        if (!view.facing || view.blocked) return;
        if (view.entered)
          precise.run(low, high, view, result.lists[k], held[k]);
        else
          pair.run(low, high, view, result.lists[k], held[k]);
      });
      done[k] = 1;
      if (progress) progress->advance();
    }
  });
  while (result.complete < done.size() && done[result.complete]) ++result.complete;
  for (size_t k = result.complete; k < asked.size(); ++k) result.lists[k].clear();
  for (size_t k = 0; k < result.complete; ++k) {
    result.largest_excess = std::max(result.largest_excess, held[k].largest_excess);
    result.held += held[k].count;
  }
}

}  // namespace

Exchanges ExchangeFinder::find(std::span<const uint32_t> leaves, Progress* progress) const {
  Exchanges result;
  result.lists.resize(leaves.size());
  parts_->single ? find_all<float>(parts_->setting, parts_->tree, leaves, result, progress)
                 : find_all<double>(parts_->setting, parts_->tree, leaves, result, progress);
  return result;
}

}  // namespace aktina
