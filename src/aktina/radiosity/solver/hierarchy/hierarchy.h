// Radiosity on a tree: linked more and more finely while the light on it is found, then balanced.
//
// P. Hanrahan, D. Salzman, L. Aupperle, "A Rapid Hierarchical Radiosity Algorithm", SIGGRAPH '91; other bases than
// constants: S. Gortler, P. Schroeder, M. Cohen, P. Hanrahan, "Wavelet Radiosity", SIGGRAPH '93.
#pragma once

#include <optional>

#include "aktina/radiosity/solver/hierarchy/cluster_links.h"
#include "aktina/radiosity/solver/hierarchy/link_refinement.h"
#include "aktina/radiosity/solver/solver.h"
#include "aktina/scene/camera.h"

namespace aktina {

struct HierarchyOptions {
  Basis basis = Basis::polynomials(1);
  Transport::Spread spread = Transport::Spread::range;
  Oracle oracle = Oracle::error;
  /// What links may not exceed in the end: form factor, or share of the flux in the scene.
  double most = 1e-5;
  /// Area of the smallest nodes over what receivers have.
  double leaf_size = 1;
  /// Surfaces are linked by clusters; of bases with one function a node.
  bool clusters = false;
  /// Links are as fine as the picture from here needs, where it is not null.
  const Camera* view = nullptr;
};

class LinkedTree {
 public:
  /// The arguments must outlive this. @throws Error limit (too many faces)
  LinkedTree(const RadiosityProblem& problem, const ReceiverSurfaces& surfaces, const HierarchyOptions& options,
             uint32_t seed);

  /// Links so that none exceeds `times` what they may in the end. In falling order. Cancelled: what there was stays.
  void link(double times, Progress* progress);
  /// One exchange of light over all links. @return flux by which radiosities have changed, all bands, weighted
  double exchange();

  const SurfaceTree& tree() const { return tree_; }
  const Links& links() const { return links_; }
  /// Of clusters with each other and with surfaces.
  size_t cluster_links() const { return clusters_ ? clusters_->size() : 0; }
  const TreeLight& light() const { return light_; }
  TreeLight& light() { return light_; }
  size_t leaves() const;

 private:
  std::vector<double> gather();

  RadiosityProblem problem_;  // with importance as its last band, where there is a view
  Basis basis_;
  SurfaceTree tree_;
  Transport transport_;
  TreeLight light_;
  LinkRefinement refinement_;
  Links links_;
  std::optional<ClusterLinks> clusters_;
  double most_;
  bool linked_ = false;
};

/// What all solvers on trees do. @throws Error unsupported (factors without surfaces), limit
/// @param method  for messages
RadiosityState solve_on_tree(std::string_view method, const RadiosityProblem& problem, const FactorSource& factors,
                             const SolverControl& control, HierarchyOptions options);

}  // namespace aktina
