// Direct light only: what lamps, emissive surfaces and the sky send to a surface without a detour, also seen in mirrors
// and through clear glass. Lamps and directions of scattering are both sampled and joined by multiple importance
// sampling. Cost: one shadow ray and one more ray a bounce. Weakness: no light from one surface to another.
//
// E. Veach, L. J. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995.
#include "aktina/trace/integrator/path_tracer.h"

namespace aktina {
namespace {

constexpr Param kParams[] = {
    {"depth", "1", "bounces in all, mirrors and clear glass included", 8, 1, 65535, true},
    {"strategy", "1", "0: lamps and scattering joined, 1: lamps alone, 2: scattering alone", 0, 0, 2, true},
};

}  // namespace

extern constinit const Method<std::unique_ptr<Integrator>> direct_integrator = {
    {"direct", "Direct light", "veach1995",
     "Light of all sources without a detour, soft shadows included; nothing passes from one matt surface to another.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<Integrator> {
      PathRules rules;
      rules.most_bounces = int(p["depth"]);
      rules.matt_bounces = 1;
      rules.strategy = LightStrategy(int(p["strategy"]));
      return integrator_by_paths(rules);
    }};

}  // namespace aktina
