#include "aktina/radiosity/solver/hierarchy/hierarchy.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/base/statistics.h"
#include "aktina/radiosity/solver/hierarchy/view_importance.h"

namespace aktina {
namespace {

constexpr size_t kGrain = 64;  // nodes
/// Of what a link may exceed where importance makes those to other places coarse: the picture is then as exact as
/// without it. Measured in four rooms in a row.
constexpr double kWithView = 0.25;

size_t coefficients_of(const Basis& basis) { return basis.most() > 1 ? basis.most() * basis.most() : 0; }

/// Some 0.4 of all pairs of faces are turned to each other, and these are linked at least.
SurfaceTree make_tree(const SurfaceLayout& layout, const Basis& basis, const HierarchyOptions& options) {
  const auto faces = double(layout.faces.size());
  const double one = Links::bytes(0.4, coefficients_of(basis));
  if (!options.clusters && one * faces * faces > Links::kMostBytes)
    throw Error(Code::limit, "radiosity", fmt::format("{} faces, and links between every two", layout.faces.size()),
                fmt::format("at most {:.0f}, or clustering, or stochastic_jacobi", std::sqrt(Links::kMostBytes / one)));
  return SurfaceTree(layout, options.leaf_size);
}

double flux_to_distribute(const RadiosityProblem& p) {
  Sum sum;
  for (size_t s = 0; s < p.size(); ++s)
    for (size_t b = 0; b < p.bands; ++b) {
      const size_t k = s * p.bands + b;
      const double lit = p.arriving.empty() ? 0 : p.reflectances[k] * p.arriving[k];
      sum.add(p.areas[s] * p.weights[b] * (p.emissions[k] + lit));
    }
  return sum.value();
}

/// One band more: importance, which shines on what the view shows and is reflected as light is.
RadiosityProblem with_importance(const RadiosityProblem& p, std::span<const double> importance) {
  double all = 0;
  for (const double w : p.weights) all += w;
  RadiosityProblem with;
  with.bands = p.bands + 1;
  with.weights = p.weights, with.weights.push_back(0);
  with.areas = p.areas, with.shooters = p.shooters;
  for (size_t s = 0; s < p.size(); ++s) {
    double reflectance = 0;
    for (size_t b = 0; b < p.bands; ++b) {
      const size_t k = s * p.bands + b;
      with.emissions.push_back(p.emissions[k]), with.reflectances.push_back(p.reflectances[k]);
      with.arriving.push_back(p.arriving.empty() ? 0 : p.arriving[k]);
      reflectance += p.weights[b] / all * p.reflectances[k];
    }
    with.emissions.push_back(0), with.reflectances.push_back(reflectance), with.arriving.push_back(importance[s]);
  }
  return with;
}

RadiosityProblem problem_on_tree(const RadiosityProblem& problem, const ReceiverSurfaces& surfaces, const Camera* view,
                                 uint32_t seed) {
  if (!view) return problem;
  return with_importance(problem,
                         view_importance(surfaces.layout(), problem.size(), surfaces.visibility(), *view, seed));
}

}  // namespace

LinkedTree::LinkedTree(const RadiosityProblem& problem, const ReceiverSurfaces& surfaces,
                       const HierarchyOptions& options, uint32_t seed)
    : problem_(problem_on_tree(problem, surfaces, options.view, seed)),
      basis_(options.basis),
      tree_(make_tree(surfaces.layout(), basis_, options)),
      transport_(basis_, options.spread),
      light_(tree_, basis_, problem_, options.view != nullptr),
      refinement_(tree_, light_, transport_, surfaces.visibility(), options.oracle, seed),
      links_(coefficients_of(basis_)),
      most_(options.most * (options.oracle == Oracle::factor ? 1 : flux_to_distribute(problem)) *
            (options.view ? kWithView : 1)) {
  if (options.clusters) clusters_.emplace(tree_, light_, surfaces.visibility(), problem_.bands, seed);
}

void LinkedTree::link(double times, Progress* progress) {
  if (clusters_)
    refinement_.refine(links_, times * most_, most_, progress, clusters_->refine(times * most_, most_, progress));
  else if (!linked_)
    refinement_.link_roots(links_, times * most_, most_, progress);
  else
    refinement_.refine(links_, times * most_, most_, progress);
  linked_ = true;
}

std::vector<double> LinkedTree::gather() {
  const size_t per_node = light_.per_node(), functions = light_.functions(), bands = problem_.bands;
  std::vector<double> gathered(tree_.nodes().size() * per_node, 0);
  parallel_for(links_.nodes(), kGrain, [&](size_t begin, size_t end) {
    for (size_t node = begin; node < end; ++node) {
      const std::span<const Link> own = links_.of(uint32_t(node));
      double* to = &gathered[node * per_node];
      for (size_t k = 0; k < own.size(); ++k) {
        if (!(own[k].visible > 0)) continue;
        const double* from = light_.radiosity(own[k].sender).data();
        if (functions == 1) {
          const double factor = double(own[k].factor) * double(own[k].visible);
          for (size_t b = 0; b < bands; ++b) to[b] += factor * from[b];
          continue;
        }
        const size_t rows = basis_.of(tree_.root(uint32_t(node)).triangle).count;
        const size_t columns = basis_.of(tree_.root(own[k].sender).triangle).count;
        const float* t = links_.coefficients(uint32_t(node), k);
        for (size_t b = 0; b < bands; ++b)
          for (size_t i = 0; i < rows; ++i) {
            double sum = 0;
            for (size_t j = 0; j < columns; ++j) sum += double(t[i * columns + j]) * from[b * functions + j];
            to[b * functions + i] += double(own[k].visible) * sum;
          }
      }
    }
  });
  if (clusters_) clusters_->gather(gathered);
  return gathered;
}

double LinkedTree::exchange() {
  const std::vector<double> before = light_.radiosities;
  light_.push_and_pull(gather());
  Sum changed;
  for (uint32_t node = 0; node < tree_.nodes().size(); ++node)
    for (size_t k = 0; tree_.is_leaf(node) && k < light_.per_node(); k += light_.functions()) {
      const size_t at = node * light_.per_node() + k;
      changed.add(tree_.area(node) * problem_.weights[k / light_.functions()] *
                  std::abs(light_.radiosities[at] - before[at]));
    }
  return changed.value();
}

size_t LinkedTree::leaves() const {
  return tree_.roots().size() + (tree_.nodes().size() - tree_.roots().size()) / 4 * 3;
}

}  // namespace aktina
