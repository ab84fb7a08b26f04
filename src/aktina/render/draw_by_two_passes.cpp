#include "aktina/base/error.h"
#include "aktina/render/job_report.h"
#include "aktina/render/picture_job.h"

namespace aktina {

LayeredImage draw_by_two_passes(PictureJob& job) {
  check_layers(job, {});
  RadiosityOptions options = job.options.radiosity;
  options.seed = job.options.seed;
  Stopwatch watch;
  const Solution solution = solve_radiosity(job.scene, options, &job.progress);
  job.report.time("solve", watch.lap());
  add_to_report(job.report, solution, job.progress);
  // Stopped in the first pass: the solution as far as it is, drawn without the second.
  if (!job.report.complete) return render_solution(job.scene, solution, job.camera, job.width, job.height);

  int taken = 0;
  TwoPassOptions second{.method = job.options.method, .samples = job.samples(16), .seed = job.options.seed};
  second.each_pass = [&](const LayeredImage& picture, int samples) {
    taken = samples;
    if (job.options.each_pass) job.options.each_pass(picture);
  };
  LayeredImage picture;
  try {
    picture = render_two_pass(job.scene, solution, job.camera, job.width, job.height, second, &job.progress);
  } catch (const Error& error) {  // stopped before the first sample: the first pass is worth keeping
    if (error.code() != Code::cancelled) throw;
    picture = render_solution(job.scene, solution, job.camera, job.width, job.height);
  }
  job.report.time("draw", watch.lap());
  job.report.count("samples", taken, "1/px");
  job.report.complete = taken >= second.samples;
  return picture;
}

}  // namespace aktina
