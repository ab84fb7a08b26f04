// Hierarchical radiosity with clusters: the whole scene is one cluster, linked to itself; links are cut between halves
// of clusters, surfaces, and quarters of surfaces, down to what the error of each link allows. Of n surfaces there are
// links in the order of n log n, where hierarchical radiosity links every two. Cost: 36 bytes a link of clusters, four
// to sixteen rays, the sum over the surfaces at both ends once. Weakness: what arrives at a cluster is shared out by
// the surfaces' orientation, not by what each of them sees.
//
// F. Sillion, "A Unified Hierarchical Algorithm for Global Illumination with Scattering Volumes and Object Clusters",
// IEEE TVCG 1(3) 1995; B. Smits, J. Arvo, D. Greenberg, "A Clustering Algorithm for Radiosity in Complex Environments",
// SIGGRAPH '94.
#include <cmath>

#include "aktina/radiosity/solver/hierarchy/hierarchy.h"

namespace aktina {
namespace {

class ClusteringSolver final : public RadiositySolver {
 public:
  RadiosityState solve(const RadiosityProblem& problem, const FactorSource& factors,
                       const SolverControl& control) const override {
    HierarchyOptions options;
    options.clusters = true, options.most = 0.02 * std::pow(control.target_error, 5.0 / 3);  // as `hierarchical`
    return solve_on_tree("clustering", problem, factors, control, options);
  }
  bool uses_importance() const override { return true; }
};

}  // namespace

extern constinit const Method<std::unique_ptr<RadiositySolver>> clustering_radiosity = {
    {"clustering", "Hierarchical radiosity with clusters", "smits1994",
     "Starts from one link, that of the whole scene with itself; for scenes of many small surfaces, without noise."},
    [](const ParamSet&) -> std::unique_ptr<RadiositySolver> { return std::make_unique<ClusteringSolver>(); }};

}  // namespace aktina
