// Which nodes are linked: pairs are cut until the error of each link is small.
#pragma once

#include <vector>

#include "aktina/base/progress.h"
#include "aktina/radiosity/solver/hierarchy/links.h"
#include "aktina/radiosity/solver/hierarchy/transport.h"
#include "aktina/radiosity/solver/hierarchy/tree_light.h"

namespace aktina {

/// What a link may not exceed.
enum class Oracle {
  factor,      // form factors, in both directions
  brightness,  // flux that it carries (BF)
  error        // flux that it may carry wrongly, by the spread of the factor and by what is half in the shade
};

class LinkRefinement {
 public:
  /// The arguments must outlive this.
  LinkRefinement(SurfaceTree& tree, TreeLight& light, const Transport& transport, const Visibility& visibility,
                 Oracle oracle, uint32_t seed)
      : tree_(tree), light_(light), transport_(transport), visibility_(visibility), oracle_(oracle), seed_(seed) {}

  /// Links every two roots that may see each other, or their parts.
  /// @param most   of the measure that the oracle looks at: form factor, or weighted flux
  /// @param final  what `most` will be in the end: how many rays are sent depends on it
  void link_roots(Links& links, double most, double final, Progress* progress);
  /// Replaces links that exceed `most` by finer ones, and links `more` nodes. Unchanged where `progress` is cancelled.
  void refine(Links& links, double most, double final, Progress* progress, std::span<const NodePair> more = {});

 private:
  struct Pair {
    uint32_t receiver, sender;
    bool clear;  // nothing is in between: it was so for their parents
  };
  enum class Verdict : uint8_t { nothing, link, cut_receiver, cut_sender };
  struct Result {
    Verdict verdict;
    bool clear;
    Link link;
  };

  double measure(const Link& link, uint32_t receiver) const;
  int rays(const Link& link, uint32_t receiver) const;
  Verdict to_cut(uint32_t receiver, uint32_t sender) const;
  Verdict judge(const Link& link, uint32_t receiver) const;
  void evaluate(std::span<const Pair> pairs, std::span<Result> results, std::span<float> coefficients,
                size_t per_link) const;
  void look(std::span<const Pair> pairs, std::span<Result> results) const;
  void cut(const Pair& pair, Verdict verdict, bool clear);
  bool drain(Links::Unsorted& kept, size_t per_link, Progress* progress);

  SurfaceTree& tree_;
  TreeLight& light_;
  const Transport& transport_;
  const Visibility& visibility_;
  Oracle oracle_;
  uint32_t seed_;
  double most_ = 0, final_ = 0;
  std::vector<Pair> open_;
};

}  // namespace aktina
