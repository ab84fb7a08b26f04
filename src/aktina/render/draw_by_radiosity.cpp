#include "aktina/render/job_report.h"
#include "aktina/render/picture_job.h"

namespace aktina {

LayeredImage draw_by_radiosity(PictureJob& job) {
  check_layers(job, {});
  RadiosityOptions options = job.options.radiosity;
  options.seed = job.options.seed;
  Stopwatch watch;
  const Solution solution = solve_radiosity(job.scene, options, &job.progress);
  job.report.time("solve", watch.lap());
  add_to_report(job.report, solution, job.progress);
  // A solution that was stopped early is drawn all the same: that takes no time worth stopping.
  Progress* const progress = job.report.complete ? &job.progress : nullptr;
  const int samples = job.samples(4);
  LayeredImage picture = render_solution(job.scene, solution, job.camera, job.width, job.height, samples, progress);
  job.report.time("draw", watch.lap());
  job.report.count("samples", samples, "1/px");
  return picture;
}

}  // namespace aktina
