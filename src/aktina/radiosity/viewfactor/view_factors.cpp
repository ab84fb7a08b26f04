#include "aktina/radiosity/viewfactor/view_factors.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/formfactor/faces.h"
#include "aktina/radiosity/viewfactor/clear_surfaces.h"
#include "aktina/radiosity/viewfactor/rows.h"

namespace aktina {
namespace {

double allowed_bytes(const ViewFactorOptions& options) {
  if (options.most_bytes > 0) return double(options.most_bytes);
  return 0.75 * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
}

/// What a pair takes until the matrix is made: itself, and both directions in compressed rows.
constexpr double kBytesPerPair = sizeof(Exchange) + 2 * 16;

/// What the matrix will take of a scratch folder; 0: it fits into memory.
double scratch_bytes(const ExchangeFinder& finder, const ViewFactorOptions& options) {
  const double n = double(finder.leaves().fragments.size()), allowed = allowed_bytes(options);
  if (0.5 * n * n * kBytesPerPair <= allowed) return 0;
  const double needed = kBytesPerPair * finder.forecast().pairs;
  if (needed <= allowed) return 0;
  if (options.scratch.empty())
    throw Error(Code::limit, "surfaces",
                fmt::format("the matrix of {} will take about {:.2g} GB, more than the {:.2g} GB allowed", size_t(n),
                            needed / 1e9, allowed / 1e9),
                fmt::format("a scratch folder for it; about {} would fit", size_t(std::sqrt(allowed / needed) * n)));
  return needed;
}

}  // namespace

double ViewFactors::row_sum(size_t i) const {
  Sum sum;
  for (uint64_t k = starts[i]; k < starts[i + 1]; ++k)
    sum.add(transmittances.empty() ? factors[k] : factors[k] * (1 - transmittances[columns[k]]));
  return sum.value();
}

double ViewFactors::at(size_t i, size_t j) const {
  const uint32_t *begin = columns.data() + starts[i], *end = columns.data() + starts[i + 1];
  const uint32_t* found = std::lower_bound(begin, end, uint32_t(j));
  return found != end && *found == j ? factors[size_t(found - columns.data())] : 0;
}

namespace {

/// @param clear  surfaces with transmittances hide nothing; else they hide all
ViewFactors find_all(const ViewFactorScene& scene, bool clear, const ViewFactorOptions& options, Progress* progress) {
  Faces faces({scene.pieces, scene.occluders});
  if (clear) {
    std::vector<uint8_t> flags;
    for (const double t : scene.transmittances) flags.push_back(t > 0);
    faces.let_through(flags);
  }
  const ExchangeFinder finder(faces, options.target_error);
  ViewFactors result;
  const double scratch = scratch_bytes(finder, options);
  if (scratch > 0 && options.foreseen) options.foreseen(scratch);
  const std::filesystem::path folder = scratch > 0 ? options.scratch : "";
  const Ownership ownership(scene, faces, finder.leaves());
  if (progress) progress->begin("view factors", "leaves", finder.leaves().leaves.size());
  const Exchanges exchanges = finder.find(folder, progress);
  if (exchanges.complete < exchanges.lists.size()) result.complete = ownership.within(exchanges.complete);
  if (!result.complete.empty() && !std::count(result.complete.begin(), result.complete.end(), 1))
    throw Error(Code::cancelled, "view factors", "stopped before a row was complete");
  result.names = scene.names, result.areas = ownership.areas();
  result.largest_excess = exchanges.largest_excess, result.held = exchanges.held;
  for (const uint64_t count : count_rows(ownership, exchanges)) result.starts.push_back(result.starts.back() + count);
  result.columns = LargeArray<uint32_t>(result.starts.back(), folder);
  result.factors = LargeArray<double>(result.starts.back(), folder);
  result.errors = LargeArray<float>(result.starts.back(), folder);
  fill_rows(ownership, exchanges, result);
  return result;
}

std::vector<double> transmittances_of(const ViewFactorScene& scene, const ViewFactors& f) {
  std::vector<double> means(scene.surfaces(), 0);
  for (size_t p = 0; p < scene.pieces.size(); ++p)
    means[scene.owners[p]] += make_face(scene.pieces[p], "").area * scene.transmittances[p] / f.areas[scene.owners[p]];
  return means;
}

}  // namespace

ViewFactors view_factors(const ViewFactorScene& scene, const ViewFactorOptions& options, Progress* progress) {
  if (scene.pieces.empty()) throw Error(Code::bad_input, "surfaces", "there is none");
  if (!(options.target_error >= 1e-8 && options.target_error <= 0.1))
    throw Error(Code::bad_param, "target_error", fmt::format("got {}", options.target_error), "accepted 1e-8 .. 0.1");
  ViewFactors closed = find_all(scene, false, options, progress);
  if (scene.transmittances.empty()) return closed;
  ViewFactors open = find_all(scene, true, options, progress);
  if (!closed.complete.empty() || !open.complete.empty())
    throw Error(Code::cancelled, "view factors", "stopped before it was known what passes clear surfaces");
  let_through(scene, closed, options.target_error, open, progress);
  open.transmittances = transmittances_of(scene, open);
  open.held += closed.held, open.largest_excess = std::max(open.largest_excess, closed.largest_excess);
  return open;
}

}  // namespace aktina
