#include "aktina/radiosity/viewfactor/rows.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include "aktina/base/parallel.h"

namespace aktina {

Ownership::Ownership(const ViewFactorScene& scene, const Faces& faces, const Leaves& leaves)
    : leaves_(leaves), areas_(scene.surfaces(), 0), of_surface_(scene.surfaces()) {
  for (size_t p = 0; p < faces.size(); ++p) areas_[scene.owners[p]] += faces[p].area;
  owners_.reserve(leaves.fragments.size());
  for (const Fragment& fragment : leaves.fragments) owners_.push_back(scene.owners[fragment.surface]);
  for (uint32_t leaf = 0; leaf < leaves.leaves.size(); ++leaf)
    for (uint32_t lane = 0; lane < leaves.leaves[leaf].count; ++lane) {
      std::vector<uint32_t>& list = of_surface_[owner(leaf, lane)];
      if (list.empty() || list.back() != leaf) list.push_back(leaf);
    }
  order_.resize(surfaces());
  std::iota(order_.begin(), order_.end(), 0U);
  std::stable_sort(order_.begin(), order_.end(), [&](uint32_t a, uint32_t b) {
    return !of_surface_[a].empty() && (of_surface_[b].empty() || of_surface_[a][0] < of_surface_[b][0]);
  });
}

std::vector<uint8_t> Ownership::within(size_t leaves) const {
  std::vector<uint8_t> flags;
  for (const std::vector<uint32_t>& own : of_surface_) flags.push_back(own.empty() || own.back() < leaves);
  return flags;
}

std::vector<uint32_t> Ownership::leaves_of(std::span<const uint32_t> surfaces) const {
  std::vector<uint32_t> all;
  for (const uint32_t i : surfaces) all.insert(all.end(), of_surface_[i].begin(), of_surface_[i].end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

namespace {

constexpr size_t kTogether = 16;  // rows: as many as a leaf has
constexpr uint8_t kOther = 0xff;  // not one of them

/// A few rows, as sums over columns and as sets of columns.
class RowBatch {
 public:
  explicit RowBatch(size_t columns)
      : words_((columns + 63) / 64),
        areas_(kTogether * columns),
        errors_(kTogether * columns),
        columns_(columns),
        sets_(kTogether * words_) {}

  void clear() { std::fill(sets_.begin(), sets_.end(), 0); }
  void note(size_t row, uint32_t j) { sets_[row * words_ + j / 64] |= uint64_t(1) << (j % 64); }
  void add(size_t row, uint32_t j, double area, float error) {
    areas_[row * columns_ + j] += area, errors_[row * columns_ + j] += error;
    note(row, j);
  }
  uint64_t count(size_t row) const {
    uint64_t sum = 0;
    for (size_t w = 0; w < words_; ++w) sum += uint64_t(std::popcount(sets_[row * words_ + w]));
    return sum;
  }
  /// Writes a row, and forgets it.
  void take(size_t row, double area, uint32_t* columns, double* factors, float* errors) {
    double* sums = &areas_[row * columns_];
    float* wrong = &errors_[row * columns_];
    const double scale = 1 / area;
    const auto put = [&](uint32_t j) {
      *columns++ = j, *factors++ = sums[j] * scale, *errors++ = float(double(wrong[j]) * scale);
      sums[j] = 0, wrong[j] = 0;
    };
    for (size_t w = 0; w < words_; ++w) {
      uint64_t left = sets_[row * words_ + w];
      if (left == ~uint64_t(0))
        for (uint32_t k = 0; k < 64; ++k) put(uint32_t(64 * w) + k);
      else
        for (; left != 0; left &= left - 1) put(uint32_t(64 * w + size_t(std::countr_zero(left))));
    }
  }

 private:
  size_t words_;
  std::vector<double> areas_;
  std::vector<float> errors_;
  size_t columns_;
  std::vector<uint64_t> sets_;
};

class RowMaker {
 public:
  RowMaker(const Ownership& ownership, const Exchanges& exchanges)
      : ownership_(ownership), surfaces_(ownership.order()), of_leaf_(exchanges.lists.size()) {
    for (const auto& list : exchanges.lists)
      for (const LeafExchange& e : list)
        for (const uint32_t leaf : {e.a, e.b}) of_leaf_[leaf].push_back(&e);
  }

  /// @param visit  (batch, row in the batch, surface), for all rows
  template <class Note, class Visit>
  void run(Note&& note, Visit&& visit) const {
    const size_t batches = (surfaces_.size() + kTogether - 1) / kTogether;
    parallel_for(batches, std::max<size_t>(1, batches / 64), [&](size_t begin, size_t end) {
      RowBatch batch(ownership_.surfaces());
      std::vector<uint8_t> place(ownership_.surfaces(), kOther);
      for (size_t b = begin; b < end; ++b) {
        const auto own = surfaces_.subspan(b * kTogether, std::min(kTogether, surfaces_.size() - b * kTogether));
        for (size_t k = 0; k < own.size(); ++k) place[own[k]] = uint8_t(k);
        batch.clear();
        for (const uint32_t leaf : ownership_.leaves_of(own))
          for (const LeafExchange* e : of_leaf_[leaf]) add(*e, leaf, place, batch, note);
        for (size_t k = 0; k < own.size(); ++k) visit(batch, k, own[k]), place[own[k]] = kOther;
      }
    });
  }

 private:
  template <class Note>
  void add(const LeafExchange& e, uint32_t leaf, const std::vector<uint8_t>& place, RowBatch& batch,
           Note&& note) const {
    const bool is_a = e.a == leaf;
    const uint32_t other = is_a ? e.b : e.a;
    uint8_t rows[kLeaf];
    uint32_t columns[kLeaf];
    for (uint32_t lane = 0; lane < kLeaf; ++lane) {
      rows[lane] = lane < ownership_.count(leaf) ? place[ownership_.owner(leaf, lane)] : kOther;
      columns[lane] = lane < ownership_.count(other) ? ownership_.owner(other, lane) : 0;
    }
    for (const Exchange& pair : e.pairs) {
      const uint8_t row = rows[is_a ? pair.of_a : pair.of_b];
      if (row != kOther) note(batch, row, columns[is_a ? pair.of_b : pair.of_a], pair);
    }
  }

  const Ownership& ownership_;
  std::span<const uint32_t> surfaces_;
  std::vector<std::vector<const LeafExchange*>> of_leaf_;
};

}  // namespace

std::vector<uint64_t> count_rows(const Ownership& ownership, const Exchanges& exchanges) {
  std::vector<uint64_t> counts(ownership.surfaces(), 0);
  if (ownership.is_one_each()) {
    for (const auto& list : exchanges.lists)
      for (const LeafExchange& e : list)
        for (const Exchange& pair : e.pairs)
          ++counts[ownership.owner(e.a, pair.of_a)], ++counts[ownership.owner(e.b, pair.of_b)];
    return counts;
  }
  RowMaker(ownership, exchanges)
      .run([](RowBatch& batch, size_t row, uint32_t j, const Exchange&) { batch.note(row, j); },
           [&](RowBatch& batch, size_t row, uint32_t i) { counts[i] = batch.count(row); });
  return counts;
}

void fill_rows(const Ownership& ownership, const Exchanges& exchanges, ViewFactors& result) {
  RowMaker(ownership, exchanges)
      .run([](RowBatch& batch, size_t row, uint32_t j,
              const Exchange& pair) { batch.add(row, j, pair.area, pair.error); },
           [&](RowBatch& batch, size_t row, uint32_t i) {
             const uint64_t at = result.starts[i];
             batch.take(row, ownership.areas()[i], result.columns.data() + at, result.factors.data() + at,
                        result.errors.data() + at);
           });
}

}  // namespace aktina
