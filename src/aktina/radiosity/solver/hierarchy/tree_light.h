// Light on a tree: what its leaves emit, reflect and receive, in the functions of a basis, and how receivers and nodes
// exchange it.
#pragma once

#include <span>
#include <vector>

#include "aktina/radiosity/solver/hierarchy/basis.h"
#include "aktina/radiosity/solver/hierarchy/surface_tree.h"
#include "aktina/radiosity/solver/problem.h"

namespace aktina {

/// Values of nodes stand by node, band and function: [(node * bands + band) * functions + function].
///
/// A leaf that is buried in part receives its light on the rest: values are means over all of it, reflectances are
/// those of the rest.
///
/// Importance is light that an eye shines on what it sees: it spreads over the same links, as one more band. What it
/// is where a node reflects it tells how much the picture gains from light that arrives there.
class TreeLight {
 public:
  /// The arguments must outlive this. All nodes are leaves yet.
  /// @param has_importance  the last band of `problem` is importance, not light
  TreeLight(const SurfaceTree& tree, const Basis& basis, const RadiosityProblem& problem, bool has_importance);

  size_t functions() const { return functions_; }
  size_t per_node() const { return per_node_; }
  std::span<const double> radiosity(uint32_t node) const { return {&radiosities[node * per_node_], per_node_}; }
  /// Mean radiosity, weighted over bands.
  double brightness(uint32_t node) const { return brightness_[node]; }
  /// Beside what is seen, on average; at most 1, and 1 everywhere where there is no view.
  double importance(uint32_t node) const { return importance_.empty() ? 1 : importance_[node]; }
  /// Sends light, or importance.
  bool shines(uint32_t node) const { return brightness_[node] > 0 || (has_importance_ && importance_[node] > 0); }
  bool has_importance() const { return has_importance_; }

  /// Takes nodes that have been cut since into account: their children get the light of their parents.
  void grow();
  /// Irradiances of nodes, as gathered by each for itself, are handed down and added up; leaves reflect them; nodes get
  /// the radiosities of their leaves.
  void push_and_pull(std::span<const double> gathered);
  /// Radiosities become what emitters send straight.
  void emit_only();

  /// Irradiances of receivers, without importance: means over them, with what arrives from lights.
  std::vector<double> receivers() const { return receivers(irradiances_); }
  std::vector<double> receivers_before() const { return receivers(before_); }

  std::vector<double> radiosities;

 private:
  void add_leaf(uint32_t node);
  void reflect(uint32_t leaf);
  std::vector<double> receivers(const std::vector<double>& irradiances) const;
  void pull();
  void scale_importance();
  double mean(const std::vector<double>& values, uint32_t node, size_t band) const;
  void push_to_children(uint32_t node, std::vector<double>& irradiances) const;
  std::vector<double> moments(uint32_t leaf, const SurfaceTree::Overlap& overlap) const;

  const SurfaceTree& tree_;
  const Basis& basis_;
  const RadiosityProblem& problem_;
  size_t functions_, per_node_;
  std::vector<double> irradiances_;  // of leaves: all; of other nodes: handed down from above and their own
  std::vector<double> before_;       // those before the last exchange
  std::vector<double> sources_;      // emitted, and reflected from lights
  std::vector<double> emitted_;
  std::vector<double> reflectances_;             // [node * bands + band]
  std::vector<double> brightness_, importance_;  // importance_: empty where there is none
  bool has_importance_;
};

}  // namespace aktina
