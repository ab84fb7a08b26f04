#include "aktina/radiosity/viewfactor/view_factors.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/viewfactor/exchange.h"

namespace aktina {
namespace {

double allowed_bytes(const ViewFactorOptions& options) {
  if (options.most_bytes > 0) return double(options.most_bytes);
  return 0.75 * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
}

/// Adds up the fragments of each surface. A surface of several pieces may see itself.
class Assembler {
 public:
  Assembler(const ViewFactorScene& scene, const Faces& faces, const Exchanges& exchanges)
      : leaves_(exchanges.leaves), members_(scene.surfaces()), below_(exchanges.blocks.size()), exchanges_(exchanges) {
    result_.names = scene.names;
    result_.areas.assign(scene.surfaces(), 0);
    for (size_t p = 0; p < faces.size(); ++p) result_.areas[scene.owners[p]] += faces[p].area;
    for (const Fragment& fragment : leaves_.fragments) owners_.push_back(scene.owners[fragment.surface]);
    for (uint32_t leaf = 0; leaf < leaves_.leaves.size(); ++leaf)
      for (uint32_t k = 0; k < leaves_.leaves[leaf].count; ++k)
        members_[owners_[leaves_.leaves[leaf].first + k]].push_back({leaf, k});
    for (const auto& blocks : exchanges.blocks)
      for (const auto& block : blocks) below_[block->b].push_back(block.get());
    sort_entries();
  }

  ViewFactors run() {
    const size_t n = members_.size();
    std::vector<Row> rows(n);
    parallel_for(n, 64, [&](size_t begin, size_t end) {
      Sums sums{std::vector<double>(n, 0), std::vector<double>(n, 0), {}};
      for (size_t i = begin; i < end; ++i) rows[i] = row(i, sums);
    });
    uint64_t entries = 0;
    for (const Row& row : rows) result_.starts.push_back(entries += row.columns.size());
    result_.columns.resize(entries), result_.factors.resize(entries), result_.errors.resize(entries);
    parallel_for(n, 64, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const auto at = std::ptrdiff_t(result_.starts[i]);
        std::copy(rows[i].columns.begin(), rows[i].columns.end(), result_.columns.begin() + at);
        std::copy(rows[i].factors.begin(), rows[i].factors.end(), result_.factors.begin() + at);
        std::copy(rows[i].errors.begin(), rows[i].errors.end(), result_.errors.begin() + at);
      }
    });
    return std::move(result_);
  }

 private:
  struct Single {
    const ExchangeEntry* entry;
    uint32_t other;
  };
  struct Member {
    uint32_t leaf, lane;
  };
  struct Row {
    std::vector<uint32_t> columns;
    std::vector<double> factors;
    std::vector<float> errors;
  };
  struct Sums {
    std::vector<double> areas, errors;
    std::vector<uint32_t> touched;
    void add(uint32_t j, double area, double error) {
      if (!(area > 0)) return;
      if (areas[j] == 0) touched.push_back(j);
      areas[j] += area, errors[j] += error;
    }
  };

  /// Both directions of single pairs, by fragment.
  void sort_entries() {
    starts_.assign(leaves_.fragments.size() + 1, 0);
    for (const auto& list : exchanges_.entries)
      for (const ExchangeEntry& e : list) ++starts_[e.a + 1], ++starts_[e.b + 1];
    for (size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    single_.resize(starts_.back());
    std::vector<uint64_t> next(starts_.begin(), starts_.end() - 1);
    for (const auto& list : exchanges_.entries)
      for (const ExchangeEntry& e : list) single_[next[e.a]++] = {&e, e.b}, single_[next[e.b]++] = {&e, e.a};
  }

  Row row(size_t i, Sums& sums) const {
    sums.touched.clear();
    for (const Member& m : members_[i]) {
      for (const auto& block : exchanges_.blocks[m.leaf])
        for (uint32_t k = 0; k < leaves_.leaves[block->b].count; ++k)
          sums.add(owner(block->b, k), block->area[m.lane][k], double(block->error[m.lane][k]));
      for (const ExchangeBlock* block : below_[m.leaf])
        for (uint32_t k = 0; k < leaves_.leaves[block->a].count; ++k)
          sums.add(owner(block->a, k), block->area[k][m.lane], double(block->error[k][m.lane]));
      const uint32_t fragment = leaves_.leaves[m.leaf].first + m.lane;
      for (uint64_t k = starts_[fragment]; k < starts_[fragment + 1]; ++k)
        sums.add(owners_[single_[k].other], single_[k].entry->area, double(single_[k].entry->error));
    }
    std::sort(sums.touched.begin(), sums.touched.end());
    Row row{sums.touched, {}, {}};
    row.factors.reserve(row.columns.size()), row.errors.reserve(row.columns.size());
    for (const uint32_t j : row.columns) {
      row.factors.push_back(sums.areas[j] / result_.areas[i]);
      row.errors.push_back(float(sums.errors[j] / result_.areas[i]));
      sums.areas[j] = sums.errors[j] = 0;
    }
    return row;
  }
  uint32_t owner(uint32_t leaf, uint32_t lane) const { return owners_[leaves_.leaves[leaf].first + lane]; }

  const Leaves& leaves_;
  std::vector<std::vector<Member>> members_;              // fragments of each surface
  std::vector<uint32_t> owners_;                          // surface of each fragment
  std::vector<std::vector<const ExchangeBlock*>> below_;  // blocks of each leaf with those below it
  const Exchanges& exchanges_;
  std::vector<uint64_t> starts_;  // of each fragment in
  std::vector<Single> single_;
  ViewFactors result_;
};

}  // namespace

double ViewFactors::row_sum(size_t i) const {
  Sum sum;
  for (uint64_t k = starts[i]; k < starts[i + 1]; ++k) sum.add(factors[k]);
  return sum.value();
}

double ViewFactors::at(size_t i, size_t j) const {
  const auto begin = columns.begin() + std::ptrdiff_t(starts[i]), end = columns.begin() + std::ptrdiff_t(starts[i + 1]);
  const auto found = std::lower_bound(begin, end, uint32_t(j));
  return found != end && *found == j ? factors[size_t(found - columns.begin())] : 0;
}

ViewFactors view_factors(const ViewFactorScene& scene, const ViewFactorOptions& options, Progress* progress) {
  if (scene.pieces.empty()) throw Error(Code::bad_input, "surfaces", "there is none");
  if (!(options.target_error >= 1e-8 && options.target_error <= 0.1))
    throw Error(Code::bad_param, "target_error", fmt::format("got {}", options.target_error), "accepted 1e-8 .. 0.1");
  const Faces faces({scene.pieces, scene.occluders});
  const Exchanges pairs = exchanges(faces, options.target_error, allowed_bytes(options), progress);
  ViewFactors result = Assembler(scene, faces, pairs).run();
  result.largest_excess = pairs.largest_excess, result.held = pairs.held;
  return result;
}

}  // namespace aktina
