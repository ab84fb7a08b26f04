#include "aktina/render/study/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/render/catalogue.h"
#include "aktina/render/job_report.h"
#include "aktina/render/study/claims.h"
#include "aktina/render/study/timing.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

constexpr RunFamily kFamilies[] = {{"formfactor", "view factors to 1e-6", run_form_factors},
                                   {"radiosity", "path", run_solvers},
                                   {"mesher", "path", run_meshers}};

constexpr RunColumn kColumns[] = {
    {"size", "1", "size", "of what is compared by size: patches", &StudyRun::size},
    {"seconds", "s", "time", "on one thread", &StudyRun::seconds},
    {"error", "1", "error", "what the chart shows", &StudyRun::error},
    {"rms_error", "1", "RMS error", "root of the mean square", &StudyRun::rms_error},
    {"largest_error", "1", "largest", "largest error", &StudyRun::largest_error},
    {"contact_error", "1", "at contacts", "median error near other surfaces", &StudyRun::contact_error},
    {"off_balance", "1", "off balance", "distance from the converged matrix solution on the same patches",
     &StudyRun::off_balance},
    {"estimated_error", "1", "its own estimate", "of its error, by the method itself", &StudyRun::estimated_error},
    {"steps", "1", "steps", "shots or sweeps", &StudyRun::steps},
    {"bytes", "B", "memory", "taken at most, above what the program had before", &StudyRun::bytes},
};

}  // namespace

std::span<const RunColumn> run_columns() { return kColumns; }

const RunFamily* find_run_family(std::string_view id) {
  for (const RunFamily& family : kFamilies)
    if (family.id == id) return &family;
  return nullptr;
}

void run_ladders(RunWork& work, double longest,
                 const std::function<std::vector<RunLadder>(const MethodStudy&)>& settings,
                 const std::function<void(const MethodStudy&, StudyRun&)>& run) {
  const ThreadsKept threads;
  set_thread_count(1);
  work.progress.begin("running", "methods", work.study.methods.size());
  for (MethodStudy& m : work.study.methods) {
    try {
      for (const RunLadder& ladder : settings(m))
        for (StudyRun one : ladder) {
          work.progress.throw_if_cancelled();
          run(m, one);
          m.runs.push_back(one);
          if (one.seconds > longest) break;
        }
    } catch (const Error& error) {
      if (error.code() != Code::unsupported && error.code() != Code::limit) throw;
      if (m.runs.empty()) m.failure = error.what();
    }
    work.progress.advance();
  }
}

std::vector<const StudyRun*> best_runs(const MethodStudy& method, double StudyRun::*x) {
  std::vector<const StudyRun*> best;
  for (const StudyRun& run : method.runs)
    if (run.*x > 0 && std::isfinite(run.error)) best.push_back(&run);
  std::sort(best.begin(), best.end(),
            [&](const StudyRun* a, const StudyRun* b) { return a->*x != b->*x ? a->*x < b->*x : a->error < b->error; });
  double least = INFINITY;
  std::erase_if(best, [&](const StudyRun* run) {
    if (!(run->error < least)) return true;
    least = run->error;
    return false;
  });
  return best;
}

double error_at(const MethodStudy& method, double StudyRun::*x, double at) {
  const std::vector<const StudyRun*> best = best_runs(method, x);
  for (size_t i = 0; i + 1 < best.size(); ++i) {
    const StudyRun &a = *best[i], &b = *best[i + 1];
    if (at < a.*x || at > b.*x || !(b.error > 0)) continue;
    const double share = std::log(at / (a.*x)) / std::log((b.*x) / (a.*x));
    return a.error * std::pow(b.error / a.error, share);
  }
  return !best.empty() && at >= best.back()->*x ? best.back()->error : kNotMeasured;
}

Study study_by_runs(const Scene& given, const StudyOptions& options, const RunFamily& family, Progress& progress) {
  if (!options.reference.empty())
    throw Error(Code::usage, "reference", fmt::format("family {} is held against {}", family.id, family.reference));
  Study result;
  result.methods = chosen_methods(family.id, options);
  const TessellatedScene scene(given);
  result.scene = display(Path(given.source).filename());
  result.family = family.id, result.reference = family.reference;
  result.report = begin_report(given, options.seed);
  result.report.settings = fmt::format("study {} --family {}", result.report.scene_file, family.id);
  if (!options.methods.empty()) result.report.settings += fmt::format(" --methods {}", fmt::join(options.methods, ","));
  result.report.settings += fmt::format(" --seed {}", options.seed);
  result.triangles = triangle_count(*scene);
  Stopwatch watch;
  RunWork work{*scene, options, progress, result};
  try {
    family.measure(work);
  } catch (const Error& error) {
    if (error.code() != Code::cancelled || result.methods[0].runs.empty()) throw;
    result.report.complete = false;
  }
  result.report.time("run", watch.lap());
  judge_claims(result);
  return result;
}

}  // namespace aktina
