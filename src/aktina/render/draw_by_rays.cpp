#include "aktina/render/picture_job.h"
#include "aktina/trace/trace.h"

namespace aktina {

LayeredImage draw_by_rays(PictureJob& job) {
  constexpr std::string_view kLayers[] = {"albedo", "N", "P", "Z", "direct", "indirect", "illuminance"};
  check_layers(job, kLayers);
  TraceOptions options{.integrator = job.options.method,
                       .samples = job.samples(job.options.method.starts_with("whitted") ? 4 : 64),
                       .seed = job.options.seed,
                       .depth_cue = job.options.depth_cue,
                       .albedo = job.wants("albedo"),
                       .normal = job.wants("N"),
                       .position = job.wants("P"),
                       .depth = job.wants("Z"),
                       .direct = job.wants("direct"),
                       .indirect = job.wants("indirect"),
                       .illuminance = job.wants("illuminance")};
  if (job.options.each_pass)
    options.each_pass = [&](const LayeredImage& picture, int) { job.options.each_pass(picture); };
  TraceStatistics statistics;
  LayeredImage picture = trace(job.scene, job.camera, job.width, job.height, options, &job.progress, &statistics);
  job.report.complete = statistics.samples == options.samples;
  job.report.time("build", statistics.build_seconds);
  job.report.time("trace", statistics.trace_seconds);
  job.report.count("samples", statistics.samples, "1/px");
  job.report.count("rays", double(statistics.rays));
  job.report.count("shadow_rays", double(statistics.shadow_rays));
  if (statistics.trace_seconds > 0)
    job.report.count("rays_per_second", double(statistics.rays + statistics.shadow_rays) / statistics.trace_seconds,
                     "1/s");
  if (statistics.not_finite > 0)
    job.report.warnings.add("samples that were not finite numbers were left out", statistics.not_finite);
  return picture;
}

}  // namespace aktina
