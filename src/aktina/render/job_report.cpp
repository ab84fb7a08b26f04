#include "aktina/render/job_report.h"

#include <fmt/core.h>

#include "aktina/base/parallel.h"

namespace aktina {

Report begin_report(const Scene& scene, uint32_t seed) {
  Report report;
  report.seed = seed;
  report.scene_file = display(Path(scene.source).filename());
  report.scene_hash = hash(scene).text();
  report.threads = thread_count();
  report.warnings.add(scene.warnings);
  return report;
}

std::string settings(const RadiosityOptions& o) {
  std::string line = fmt::format(
      "--solver {} --quality {} --formfactor {} --mesher {} --patch-size {} --tolerance {} --target-error {} "
      "--indirect-size {}",
      o.solver, o.quality, o.formfactor, o.mesher, o.patch_size, o.tolerance, o.target_error, o.indirect_size);
  if (o.importance) line += fmt::format(" --importance '{}'", o.importance->name);
  if (o.most_steps > 0) line += fmt::format(" --max-steps {}", o.most_steps);
  return line;
}

}  // namespace aktina
