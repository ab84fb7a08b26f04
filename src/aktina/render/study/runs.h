// Families whose methods compute numbers: each method is run at several settings, from coarse to fine, and its error is
// held against an exact or converged answer.
#pragma once

#include <functional>

#include "aktina/base/method.h"
#include "aktina/render/study/study.h"

namespace aktina {

/// What a study by runs has to work with.
struct RunWork {
  const Scene& scene;  // without primitives
  const StudyOptions& options;
  Progress& progress;
  Study& study;  // its methods are chosen; runs, remarks and the names of what is measured are filled
};

struct RunFamily {
  std::string_view id, reference;
  void (*measure)(RunWork& work);
};

/// Null where the family's methods are compared by pictures.
const RunFamily* find_run_family(std::string_view id);

/// @throws Error usage (a reference of one's own: there is none to choose), and as the family's methods
Study study_by_runs(const Scene& scene, const StudyOptions& options, const RunFamily& family, Progress& progress);

/// The methods of a family that the options ask for. @throws Error no_such_method
std::vector<MethodStudy> chosen_methods(std::string_view family, const StudyOptions& options);

void run_form_factors(RunWork& work);
void run_solvers(RunWork& work);
void run_meshers(RunWork& work);

/// Runs each method at each setting in turn on one thread; a method that cannot take the scene says so in its failure.
/// @param settings  of a method, in ladders from coarse to fine; a ladder ends with the first run that takes longer
/// than `longest`, s
using RunLadder = std::vector<StudyRun>;
void run_ladders(RunWork& work, double longest,
                 const std::function<std::vector<RunLadder>(const MethodStudy&)>& settings,
                 const std::function<void(const MethodStudy&, StudyRun&)>& run);

/// Those runs than which no other one of the method is both lower in `x` and in error, by x.
std::vector<const StudyRun*> best_runs(const MethodStudy& method, double StudyRun::*x);

/// Error of the method's best runs at x, interpolated in the logarithms; unknown outside of them.
double error_at(const MethodStudy& method, double StudyRun::*x, double at);

/// The numbers of a run by name: the same ones in report.json and report.html.
struct RunColumn {
  std::string_view name, unit, title, help;
  double StudyRun::*value;
};
std::span<const RunColumn> run_columns();

}  // namespace aktina
