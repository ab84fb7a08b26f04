#include "aktina/radiosity/viewfactor/view_factors.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/viewfactor/exchange.h"

namespace aktina {
namespace {

constexpr double kBytesPerEntry = sizeof(double) + sizeof(uint32_t) + sizeof(float);

double allowed_bytes(const ViewFactorOptions& options) {
  if (options.most_bytes > 0) return double(options.most_bytes);
  return 0.75 * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
}

void check_memory(size_t pieces, size_t surfaces, const ViewFactorOptions& options) {
  const double needed = view_factor_bytes(pieces, surfaces), allowed = allowed_bytes(options);
  if (needed <= allowed) return;
  const double fits = std::sqrt(allowed / needed) * double(pieces);
  throw Error(Code::limit, "surfaces",
              fmt::format("the matrix of {} may take {:.1f} GB, more than the {:.1f} GB allowed", pieces, needed / 1e9,
                          allowed / 1e9),
              fmt::format("about {} polygons fit", size_t(fits)));
}

/// Both directions of each pair of pieces, row after row.
struct PieceRows {
  std::vector<uint64_t> starts;
  std::vector<Exchange> entries;

  explicit PieceRows(Exchanges& half) {
    const size_t n = half.rows.size();
    starts.assign(n + 1, 0);
    for (size_t i = 0; i < n; ++i) {
      starts[i + 1] += half.rows[i].size();
      for (const Exchange& e : half.rows[i]) ++starts[e.other + 1];
    }
    for (size_t i = 0; i < n; ++i) starts[i + 1] += starts[i];
    entries.resize(starts[n]);
    std::vector<uint64_t> next(starts.begin(), starts.end() - 1);
    for (size_t i = 0; i < n; ++i) {  // ascending: the pairs below i have come before
      for (const Exchange& e : half.rows[i]) {
        entries[next[i]++] = e;
        entries[next[e.other]++] = {uint32_t(i), e.error, e.area};
      }
      half.rows[i] = {};
    }
  }
};

/// Adds up the pieces of each surface. A surface of several pieces may see itself.
class Assembler {
 public:
  Assembler(const ViewFactorScene& scene, const Faces& faces, const PieceRows& rows)
      : scene_(scene), rows_(rows), members_(scene.surfaces()), sums_(scene.surfaces()), errors_(scene.surfaces()) {
    result_.names = scene.names;
    result_.areas.assign(scene.surfaces(), 0);
    for (size_t p = 0; p < faces.size(); ++p) {
      members_[scene.owners[p]].push_back(uint32_t(p));
      result_.areas[scene.owners[p]] += faces[p].area;
    }
  }

  ViewFactors run() {
    for (size_t i = 0; i < members_.size(); ++i) {
      touched_.clear();
      for (const uint32_t piece : members_[i]) add(piece);
      std::sort(touched_.begin(), touched_.end());
      for (const uint32_t j : touched_) {
        result_.columns.push_back(j);
        result_.factors.push_back(sums_[j] / result_.areas[i]);
        result_.errors.push_back(float(errors_[j] / result_.areas[i]));
        sums_[j] = errors_[j] = 0;
      }
      result_.starts.push_back(result_.columns.size());
    }
    return std::move(result_);
  }

 private:
  void add(uint32_t piece) {
    for (uint64_t k = rows_.starts[piece]; k < rows_.starts[piece + 1]; ++k) {
      const Exchange& e = rows_.entries[k];
      const uint32_t j = scene_.owners[e.other];
      if (sums_[j] == 0) touched_.push_back(j);
      sums_[j] += e.area, errors_[j] += double(e.error);
    }
  }

  const ViewFactorScene& scene_;
  const PieceRows& rows_;
  std::vector<std::vector<uint32_t>> members_;
  std::vector<double> sums_, errors_;
  std::vector<uint32_t> touched_;
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

double view_factor_bytes(size_t pieces, size_t surfaces) {
  const double p = double(pieces), n = double(surfaces);
  return (1.5 * sizeof(Exchange)) * p * p + kBytesPerEntry * n * n;
}

ViewFactors view_factors(const ViewFactorScene& scene, const ViewFactorOptions& options, Progress* progress) {
  if (scene.pieces.empty()) throw Error(Code::bad_input, "surfaces", "there is none");
  if (!(options.target_error >= 1e-8 && options.target_error <= 0.1))
    throw Error(Code::bad_param, "target_error", fmt::format("got {}", options.target_error), "accepted 1e-8 .. 0.1");
  check_memory(scene.pieces.size(), scene.surfaces(), options);
  const Faces faces({scene.pieces, scene.occluders});
  Exchanges half = exchanges(faces, options.target_error, progress);
  const double excess = half.largest_excess;
  const uint64_t held = half.held;
  ViewFactors result = Assembler(scene, faces, PieceRows(half)).run();
  result.largest_excess = excess, result.held = held;
  return result;
}

}  // namespace aktina
