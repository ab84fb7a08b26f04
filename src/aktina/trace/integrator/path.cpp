// Path tracing: the rendering equation by random walks. At each bounce one lamp is sampled and one direction of the
// surface's scattering, joined by multiple importance sampling; long paths end by Russian roulette, without bias.
// Cost: a few rays a bounce, thousands of samples a pixel for a clean picture. Weakness: light through clear glass or
// off mirrors onto matt surfaces (caustics) is found only by chance, and never of point, spot and distant lamps.
//
// J. T. Kajiya, "The Rendering Equation", SIGGRAPH 1986; E. Veach, L. J. Guibas, "Optimally Combining Sampling
// Techniques for Monte Carlo Rendering", SIGGRAPH 1995.
#include "aktina/trace/integrator/path_tracer.h"

namespace aktina {
namespace {

constexpr Param kParams[] = {
    {"depth", "1", "bounces a path may have", 64, 0, 65535, true},
    {"roulette", "1", "bounces after which a path may end by chance", 3, 0, 65535, true},
};

}  // namespace

extern constinit const Method<std::unique_ptr<Integrator>> path_integrator = {
    {"path", "Path tracing", "kajiya1986",
     "All light paths by random walks, without bias: noise falls with the root of the samples; caustics of small lamps "
     "stay noisy.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<Integrator> {
      PathRules rules;
      rules.most_bounces = rules.matt_bounces = int(p["depth"]);
      rules.roulette = int(p["roulette"]);
      return integrator_by_paths(rules);
    }};

}  // namespace aktina
