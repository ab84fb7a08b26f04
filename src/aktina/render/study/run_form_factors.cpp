// Each estimator of form factors against the exact ones of a scene's faces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aktina/base/error.h"
#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/viewfactor/scene_surfaces.h"
#include "aktina/render/report.h"
#include "aktina/render/study/runs.h"
#include "aktina/render/study/within.h"

namespace aktina {
namespace {

constexpr size_t kMostSurfaces = 1000, kMostRows = 24;
constexpr double kLongest = 0.25;     // s: finer settings are left out
constexpr double kMost = 5;           // s, of one run: a method that needs more is left out
constexpr double kExact = 1e-6;       // of the reference's factors
constexpr size_t kMostClipped = 100;  // polygons that are clipped with each other in a time one waits for

/// Faces, some of them as receivers, and their exact factors.
struct Truth {
  FormFactorScene scene;
  std::vector<size_t> rows;
  std::vector<std::vector<double>> factors;  // of each row
};

Truth exact_rows(RunWork& work) {
  ViewFactorScene all = surfaces_of(work.scene, SurfacesBy::face);
  const size_t n = all.pieces.size();
  if (n > kMostSurfaces)
    throw Error(Code::limit, work.scene.source, fmt::format("has {} faces", n),
                fmt::format("the study of form factors takes {} at most", kMostSurfaces));
  all.owners.resize(n), all.names.clear();
  std::iota(all.owners.begin(), all.owners.end(), 0U);
  for (size_t i = 0; i < n; ++i) all.names.push_back(std::to_string(i));
  all.emissivities.clear();
  Truth truth{{all.pieces, all.occluders}, {}, {}};
  const ViewFactors exact =
      within(work.progress, [&](Progress& inner) { return view_factors(all, {.target_error = kExact}, &inner); });
  work.progress.throw_if_cancelled();
  const size_t count = std::min(n, kMostRows);
  for (size_t k = 0; k < count; ++k) {
    truth.rows.push_back(k * n / count);
    std::vector<double>& row = truth.factors.emplace_back(n);
    for (size_t j = 0; j < n; ++j) row[j] = exact.at(truth.rows.back(), j);
  }
  return truth;
}

void run_one(RunWork& work, const Truth& truth, const std::string& id, StudyRun& run) {
  const size_t n = truth.scene.surfaces.size() + truth.scene.occluders.size();
  if (id == "contour" && n > kMostClipped)
    throw Error(Code::limit, run.choice, fmt::format("clips each polygon with all others, and there are {}", n),
                fmt::format("the study waits for {} at most", kMostClipped));
  const auto method = make_method(formfactors(), "formfactor", run.choice);
  std::vector<FormFactorRow> rows;
  Stopwatch watch;
  run.seconds = 0;
  method->build(truth.scene);
  for (const size_t i : truth.rows) {
    work.progress.throw_if_cancelled();
    rows.push_back(method->row(i));
    run.seconds += watch.lap();
    if (run.seconds > kMost)
      throw Error(Code::limit, run.choice,
                  fmt::format("{} rows of {} took {:.3g} s here", rows.size(), truth.rows.size(), run.seconds),
                  fmt::format("a run may take {:g} s", kMost));
  }
  double squares = 0, estimates = 0, largest = 0, count = 0;
  for (size_t k = 0; k < rows.size(); ++k)
    for (size_t j = 0; j < truth.factors[k].size(); ++j, ++count) {
      const double off = std::abs(rows[k].factors[j] - truth.factors[k][j]), own = rows[k].errors[j];
      squares += off * off, estimates += own * own, largest = std::max(largest, off);
    }
  run.error = std::sqrt(squares / count), run.largest_error = largest;
  run.estimated_error = std::sqrt(estimates / count);
}

std::string with(const MethodInfo& info, const Param& own, double value, bool others_least) {
  std::string text = fmt::format("{}:{}={:g}", info.id, own.id, value);
  if (others_least)
    for (const Param& p : info.params)
      if (&p != &own && p.whole && p.id != "seed" && p.id != "resolution") text += fmt::format(",{}={:g}", p.id, p.min);
  return text;
}

/// Values of one parameter about its default, from coarse to fine; counts in steps of four, edges of two.
RunLadder ladder(const MethodInfo& info, const Param& p, bool others_least) {
  RunLadder runs;
  const double step = !p.whole ? 0.1 : p.id == "resolution" ? 2 : 4;
  for (int k = -4; k <= 1; ++k) {
    const double value = p.value * std::pow(step, k), rounded = p.whole ? std::round(value) : value;
    if (rounded < p.min || rounded > p.max) continue;
    StudyRun& run = runs.emplace_back();
    run.choice = with(info, p, rounded, others_least);
    run.parameter = p.id, run.value = rounded, run.others_least = others_least;
  }
  return runs;
}

std::vector<RunLadder> ladders(const MethodStudy& m) {
  if (m.choice != m.id) return {{{.choice = m.choice}}};
  const MethodInfo& info = find_method(formfactors(), "formfactor", m.id).info;
  std::vector<RunLadder> all;
  const auto counts =
      std::count_if(info.params.begin(), info.params.end(), [](const Param& p) { return p.whole && p.id != "seed"; });
  for (const Param& p : info.params) {
    if (p.id == "seed") continue;
    all.push_back(ladder(info, p, false));
    if (counts > 1 && p.whole) all.push_back(ladder(info, p, true));
  }
  return all;
}

}  // namespace

void run_form_factors(RunWork& work) {
  work.progress.begin("exact form factors", "faces", 0);
  const Truth truth = exact_rows(work);
  work.study.error_name = "RMS error of a form factor";
  work.study.size_name = "";
  work.study.remarks.push_back(
      fmt::format("{} rows of {} faces each; the reference is exact to {:g}. Time is that of these rows, with what is "
                  "built for them.",
                  truth.rows.size(), truth.scene.surfaces.size(), kExact));
  run_ladders(work, kLongest, ladders, [&](const MethodStudy& m, StudyRun& run) { run_one(work, truth, m.id, run); });
}

}  // namespace aktina
