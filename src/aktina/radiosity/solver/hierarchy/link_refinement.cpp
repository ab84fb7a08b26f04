#include "aktina/radiosity/solver/hierarchy/link_refinement.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr size_t kBatch = 1 << 15;  // pairs that are looked at before the tree grows
constexpr size_t kChunk = 128;      // of one thread
constexpr int kFewRays = 4, kUsualRays = 16, kManyRays = 64;
constexpr float kClear = 0.999f;  // share of rays that pass where nothing is in the way
constexpr float kDoubt = 0.1f;    // what may be visible where no ray passes: 0 of 16 is no proof

void check_memory(size_t links, size_t per_link) {
  if (Links::bytes(double(links), per_link) > Links::kMostBytes)
    throw Error(Code::limit, "target_error", fmt::format("more than {} links, which take 2 GiB", links),
                "a higher target error, or larger patches");
}

}  // namespace

/// What the oracle looks at. Where some rays pass, the edge of a shadow lies across.
double LinkRefinement::measure(const Link& link, uint32_t receiver) const {
  if (link.visible < 0) return 0;
  const double brightness = light_.brightness(link.sender) * light_.importance(receiver), area = tree_.area(receiver);
  const float seen = std::max(link.visible, kDoubt);
  if (oracle_ == Oracle::factor) {
    if (!(brightness > 0)) return 0;
    return double(link.factor * seen) * std::max(1.0, area / tree_.area(link.sender)) * light_.importance(receiver);
  }
  if (oracle_ == Oracle::brightness) return brightness * area * double(link.factor * seen);
  float error = link.spread * seen;
  if (link.visible < kClear) error += link.factor * std::max(link.visible * (1 - link.visible), kDoubt);
  return brightness * area * double(error);
}

int LinkRefinement::rays(const Link& link, uint32_t receiver) const {
  const double flux = oracle_ == Oracle::factor ? double(link.factor)
                                                : light_.brightness(link.sender) * light_.importance(receiver) *
                                                      tree_.area(receiver) * double(link.factor);
  return flux < 0.5 * final_ ? kFewRays : flux < 32 * final_ ? kUsualRays : kManyRays;
}

/// The larger one, or the one that may be cut.
LinkRefinement::Verdict LinkRefinement::to_cut(uint32_t receiver, uint32_t sender) const {
  const bool larger = tree_.area(receiver) >= tree_.area(sender);
  if (tree_.may_be_cut(larger ? receiver : sender)) return larger ? Verdict::cut_receiver : Verdict::cut_sender;
  if (tree_.may_be_cut(larger ? sender : receiver)) return larger ? Verdict::cut_sender : Verdict::cut_receiver;
  return Verdict::link;
}

LinkRefinement::Verdict LinkRefinement::judge(const Link& link, uint32_t receiver) const {
  return measure(link, receiver) > most_ ? to_cut(receiver, link.sender) : Verdict::link;
}

void LinkRefinement::evaluate(std::span<const Pair> pairs, std::span<Result> results, std::span<float> coefficients,
                              size_t per_link) const {
  for (size_t k = 0; k < pairs.size(); ++k) {
    const Pair& pair = pairs[k];
    Result& result = results[k];
    result = {Verdict::nothing, pair.clear, {pair.sender, 0, 0, -1}};
    const TreePatch receiver = tree_.patch(pair.receiver), sender = tree_.patch(pair.sender);
    if (tree_.nodes()[pair.receiver].covered == 0 || tree_.nodes()[pair.sender].covered == 0) continue;
    if (turned_away(receiver, sender)) continue;
    result.verdict = Verdict::link;
    if (!light_.shines(pair.sender)) continue;
    const NodeExchange exchange = transport_.sample(receiver, sender, per_link ? &coefficients[k * per_link] : nullptr);
    result.link = {pair.sender, exchange.factor, exchange.spread, 1};
  }
  look(pairs, results);
  for (size_t k = 0; k < pairs.size(); ++k) {
    if (results[k].verdict == Verdict::nothing || results[k].link.visible < 0) continue;
    results[k].verdict = judge(results[k].link, pairs[k].receiver);
    if (per_link == 0 || results[k].verdict != Verdict::link) continue;
    const TreePatch receiver = tree_.patch(pairs[k].receiver), sender = tree_.patch(pairs[k].sender);
    if (Transport::near(receiver, sender)) transport_.sample_near(receiver, sender, &coefficients[k * per_link]);
  }
}

void LinkRefinement::look(std::span<const Pair> pairs, std::span<Result> results) const {
  float passed[kChunk] = {}, weights[kChunk] = {};
  VisibilityQueue queue(visibility_, Coherence::coherent, passed);
  for (size_t k = 0; k < pairs.size(); ++k) {
    const Link& link = results[k].link;
    if (results[k].verdict == Verdict::nothing || link.visible < 0 || results[k].clear) continue;
    const int count = rays(link, pairs[k].receiver);
    const uint32_t seed = hash_combine(hash_combine(seed_, pairs[k].receiver), pairs[k].sender);
    weights[k] = look_between(tree_.patch(pairs[k].receiver), tree_.patch(pairs[k].sender), count, seed, visibility_,
                              queue, uint32_t(k));
    results[k].clear = count > kFewRays;
  }
  queue.flush();
  for (size_t k = 0; k < pairs.size(); ++k) {
    if (!(weights[k] > 0)) continue;
    Link& link = results[k].link;
    link.visible = std::min(passed[k] / weights[k], 1.0f);
    if (link.visible > kClear)
      link.visible = 1;
    else
      results[k].clear = false;
  }
}

void LinkRefinement::cut(const Pair& pair, Verdict verdict, bool clear) {
  const uint32_t node = verdict == Verdict::cut_receiver ? pair.receiver : pair.sender;
  const uint32_t first = tree_.is_leaf(node) ? tree_.cut(node) : tree_.nodes()[node].children;
  for (uint32_t c = 0; c < 4; ++c)
    open_.push_back(verdict == Verdict::cut_receiver ? Pair{first + c, pair.sender, clear}
                                                     : Pair{pair.receiver, first + c, clear});
}

/// Deals with open pairs until none is left. @return false where it was cancelled
bool LinkRefinement::drain(Links::Unsorted& kept, size_t per_link, Progress* progress) {
  std::vector<Pair> pairs;
  std::vector<Result> results;
  std::vector<float> coefficients;
  while (!open_.empty()) {
    if (progress && progress->cancelled()) return false;
    const size_t count = std::min(open_.size(), kBatch);
    pairs.assign(open_.end() - std::ptrdiff_t(count), open_.end());
    open_.resize(open_.size() - count);
    results.resize(count), coefficients.resize(count * per_link);
    const size_t chunks = (count + kChunk - 1) / kChunk;
    parallel_for(chunks, 1, [&](size_t begin, size_t end) {
      for (size_t chunk = begin; chunk < end; ++chunk) {
        const size_t first = chunk * kChunk, n = std::min(kChunk, count - first);
        evaluate({&pairs[first], n}, {&results[first], n},
                 std::span<float>(coefficients).subspan(first * per_link, n * per_link), per_link);
      }
    });
    check_memory(kept.links.size() + count, per_link);
    const size_t nodes = tree_.nodes().size();
    uint64_t links = 0;
    for (size_t k = 0; k < count; ++k) {
      const Result& result = results[k];
      if (result.verdict == Verdict::nothing) continue;
      if (result.verdict == Verdict::link)
        kept.add(pairs[k].receiver, result.link, std::span<float>(coefficients).subspan(k * per_link, per_link)),
            ++links;
      else
        cut(pairs[k], result.verdict, result.clear);
    }
    if (tree_.nodes().size() > nodes) light_.grow();
    if (progress) progress->advance(links);
  }
  return true;
}

void LinkRefinement::link_roots(Links& links, double most, double final, Progress* progress) {
  most_ = most, final_ = final;
  Links::Unsorted kept;
  const auto roots = uint32_t(tree_.roots().size());
  for (uint32_t receiver = 0; receiver < roots; ++receiver) {
    for (uint32_t sender = 0; sender < roots; ++sender)
      if (sender != receiver) open_.push_back({receiver, sender, false});
    if (open_.size() < kBatch && receiver + 1 < roots) continue;
    if (!drain(kept, links.per_link(), progress)) break;
  }
  open_.clear();
  links.replace(kept, tree_.nodes().size());
}

void LinkRefinement::refine(Links& links, double most, double final, Progress* progress,
                            std::span<const NodePair> more) {
  most_ = most, final_ = final;
  Links::Unsorted kept;
  for (const NodePair& pair : more) open_.push_back({pair.receiver, pair.sender, false});
  for (uint32_t receiver = 0; receiver < links.nodes(); ++receiver) {
    const std::span<const Link> own = links.of(receiver);
    for (size_t k = 0; k < own.size(); ++k) {
      const Link& link = own[k];
      if (link.visible < 0 && light_.shines(link.sender)) {
        open_.push_back({receiver, link.sender, false});
        continue;
      }
      const Verdict verdict = judge(link, receiver);
      if (verdict == Verdict::link)
        kept.add(receiver, link, {links.coefficients(receiver, k), links.per_link()});
      else
        cut({receiver, link.sender, false}, verdict, link.visible == 1);
    }
  }
  if (tree_.nodes().size() > links.nodes()) light_.grow();
  const bool done = drain(kept, links.per_link(), progress);
  open_.clear();
  if (done || links.size() == 0) links.replace(kept, tree_.nodes().size());
}

}  // namespace aktina
