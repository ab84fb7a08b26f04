#include "aktina/trace/integrator/integrator.h"

#include "aktina/base/error.h"

namespace aktina {

void Integrator::set_depth_cue(const DepthCue& /*cue*/) {
  throw Error(Code::usage, "depth_cue", "this way of tracing rays has no depth cueing", "raster and whitted have");
}

}  // namespace aktina
