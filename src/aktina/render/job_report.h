// What the reports of all jobs have in common.
#pragma once

#include "aktina/render/job.h"

namespace aktina {

/// Scene, its warnings, seed and threads.
Report begin_report(const Scene& scene, uint32_t seed);

/// Options as on the command line: "--solver progressive --formfactor ray_cast ...".
std::string settings(const RadiosityOptions& options);

/// Counts, energy and convergence of a solution; complete unless it was stopped before it converged.
void add_to_report(Report& report, const Solution& solution, const Progress& progress);

}  // namespace aktina
