#include "aktina/radiosity/viewfactor/view_factors.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aktina/base/error.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/viewfactor/rows.h"

namespace aktina {
namespace {

double allowed_bytes(const ViewFactorOptions& options) {
  if (options.most_bytes > 0) return double(options.most_bytes);
  return 0.75 * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
}

/// What a pair takes until the matrix is made: itself, and both directions in compressed rows.
constexpr double kBytesPerPair = sizeof(Exchange) + 2 * 16;

void check_memory(const ExchangeFinder& finder, double allowed) {
  const double n = double(finder.leaves().fragments.size());
  if (0.5 * n * n * kBytesPerPair <= allowed) return;
  const double needed = kBytesPerPair * finder.forecast().pairs;
  if (needed <= allowed) return;
  throw Error(Code::limit, "surfaces",
              fmt::format("the matrix of {} will take about {:.2g} GB, more than the {:.2g} GB allowed", size_t(n),
                          needed / 1e9, allowed / 1e9),
              fmt::format("about {} would fit", size_t(std::sqrt(allowed / needed) * n)));
}

}  // namespace

double ViewFactors::row_sum(size_t i) const {
  Sum sum;
  for (uint64_t k = starts[i]; k < starts[i + 1]; ++k) sum.add(factors[k]);
  return sum.value();
}

double ViewFactors::at(size_t i, size_t j) const {
  const uint32_t *begin = columns.data() + starts[i], *end = columns.data() + starts[i + 1];
  const uint32_t* found = std::lower_bound(begin, end, uint32_t(j));
  return found != end && *found == j ? factors[size_t(found - columns.data())] : 0;
}

ViewFactors view_factors(const ViewFactorScene& scene, const ViewFactorOptions& options, Progress* progress) {
  if (scene.pieces.empty()) throw Error(Code::bad_input, "surfaces", "there is none");
  if (!(options.target_error >= 1e-8 && options.target_error <= 0.1))
    throw Error(Code::bad_param, "target_error", fmt::format("got {}", options.target_error), "accepted 1e-8 .. 0.1");
  const Faces faces({scene.pieces, scene.occluders});
  const ExchangeFinder finder(faces, options.target_error);
  check_memory(finder, allowed_bytes(options));
  const Ownership ownership(scene, faces, finder.leaves());
  std::vector<uint32_t> leaves(finder.leaves().leaves.size());
  std::iota(leaves.begin(), leaves.end(), 0U);
  if (progress) progress->begin("view factors", "leaves", leaves.size());
  const Exchanges exchanges = finder.find(leaves, progress);
  if (exchanges.complete == 0) throw Error(Code::cancelled, "view factors", "stopped before a row was complete");
  ViewFactors result;
  if (exchanges.complete < leaves.size()) result.complete = ownership.within(exchanges.complete);
  result.names = scene.names, result.areas = ownership.areas();
  result.largest_excess = exchanges.largest_excess, result.held = exchanges.held;
  std::vector<uint64_t> counts(ownership.surfaces());
  count_rows(ownership, ownership.order(), leaves, exchanges, counts);
  for (const uint64_t count : counts) result.starts.push_back(result.starts.back() + count);
  result.columns = LargeArray<uint32_t>(result.starts.back());
  result.factors = LargeArray<double>(result.starts.back());
  result.errors = LargeArray<float>(result.starts.back());
  fill_rows(ownership, ownership.order(), leaves, exchanges, result);
  return result;
}

}  // namespace aktina
