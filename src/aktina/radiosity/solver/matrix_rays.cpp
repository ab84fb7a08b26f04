#include "aktina/radiosity/solver/matrix_rays.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr double kMostEntries = 1 << 28;  // 2 GiB

size_t checked_count(const RadiosityProblem& problem) {
  const size_t rows = problem.size(), columns = problem.shooters.size();
  if (double(rows) * double(columns) > kMostEntries)
    throw Error(Code::limit, "matrix", fmt::format("{} x {} form factors", rows, columns),
                "larger patches, or form factors by ray_cast");
  return rows * columns;
}

}  // namespace

MatrixRays::MatrixRays(const RadiosityProblem& problem, const FactorSource& factors, const SolverControl& control)
    : problem_(problem), sums_(control.checkpoint, "form factors", checked_count(problem)), seed_(control.seed) {
  const size_t rows = problem.size(), columns = problem.shooters.size();
  std::vector<double> column(rows), &sums = sums_.values;
  if (control.progress) control.progress->begin("form factors", "columns", columns);
  sums_.loop.run(columns, 1, control.progress, [&](size_t begin, size_t end) {
    for (size_t j = begin; j < end && !control.stopped(0); ++j) {
      factors.column(j, column);
      for (size_t s = 0; s < rows; ++s) sums[s * columns + j] = column[s] + (j > 0 ? sums[s * columns + j - 1] : 0);
      if (control.progress) control.progress->advance();
    }
  });
  double sum = 0;
  for (const double a : problem.areas) areas_.push_back(sum += a);
}

void MatrixRays::follow(std::span<const Ray> rays, std::vector<Arrival>& arrivals) const {
  const size_t columns = problem_.shooters.size();
  for (uint32_t k = 0; k < rays.size(); ++k) {
    const Vec2 u = sobol_owen(rays[k].number, hash_combine(seed_, rays[k].from));
    const double* row = &sums_.values[rays[k].from * columns];
    const double* to = std::upper_bound(row, row + columns, double(u.x));
    if (to == row + columns) continue;
    const RadiosityProblem::Range range = problem_.shooters[size_t(to - row)];
    const double before = range.first > 0 ? areas_[range.first - 1] : 0;
    const double target = before + double(u.y) * (areas_[range.first + range.count - 1] - before);
    const auto first = areas_.begin() + range.first, last = first + range.count - 1;
    arrivals.push_back({k, uint32_t(std::upper_bound(first, last, target) - areas_.begin()), 1});
  }
}

}  // namespace aktina
