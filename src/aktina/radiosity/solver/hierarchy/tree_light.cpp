#include "aktina/radiosity/solver/hierarchy/tree_light.h"

#include <algorithm>
#include <cmath>

namespace aktina {

TreeLight::TreeLight(const SurfaceTree& tree, const Basis& basis, const RadiosityProblem& problem, bool has_importance)
    : tree_(tree),
      basis_(basis),
      problem_(problem),
      functions_(basis.most()),
      per_node_(functions_ * problem.bands),
      has_importance_(has_importance) {
  grow();
}

void TreeLight::grow() {
  const size_t before = brightness_.size(), now = tree_.nodes().size();
  for (std::vector<double>* values : {&radiosities, &irradiances_, &before_, &sources_, &emitted_})
    values->resize(now * per_node_, 0);
  reflectances_.resize(now * problem_.bands, 0), brightness_.resize(now, 0);
  for (size_t node = before; node < now; ++node) add_leaf(uint32_t(node));
  for (uint32_t node = 0; node < now; ++node)  // children follow their parents
    if (!tree_.is_leaf(node) && tree_.nodes()[node].children >= before) {
      const size_t first = tree_.nodes()[node].children;
      for (std::vector<double>* values : {&irradiances_, &before_}) {
        std::fill_n(&(*values)[first * per_node_], 4 * per_node_, 0.0);
        push_to_children(node, *values);
      }
    }
  for (size_t node = before; node < now; ++node) reflect(uint32_t(node));
  pull();
}

std::vector<double> TreeLight::moments(uint32_t leaf, const SurfaceTree::Overlap& overlap) const {
  if (functions_ == 1) return {overlap.area / tree_.area(leaf)};
  return basis_.of(tree_.root(leaf).triangle).moments(tree_.common_part(leaf, overlap.piece));
}

void TreeLight::add_leaf(uint32_t node) {
  const size_t bands = problem_.bands;
  double covered = 0;
  for (const SurfaceTree::Overlap& each : tree_.overlaps(node)) {
    const std::vector<double> part = moments(node, each);
    covered += each.area;
    for (size_t b = 0; b < bands; ++b) {
      const size_t k = each.receiver * bands + b;
      const double lit = problem_.arriving.empty() ? 0 : problem_.reflectances[k] * problem_.arriving[k];
      reflectances_[node * bands + b] += each.area * problem_.reflectances[k];
      for (size_t i = 0; i < part.size(); ++i) {
        emitted_[node * per_node_ + b * functions_ + i] += part[i] * problem_.emissions[k];
        sources_[node * per_node_ + b * functions_ + i] += part[i] * (problem_.emissions[k] + lit);
      }
    }
  }
  for (size_t b = 0; b < bands && covered > 0; ++b) reflectances_[node * bands + b] /= covered;
}

void TreeLight::reflect(uint32_t leaf) {
  for (size_t b = 0; b < problem_.bands; ++b)
    for (size_t i = 0; i < functions_; ++i) {
      const size_t k = leaf * per_node_ + b * functions_ + i;
      radiosities[k] = sources_[k] + reflectances_[leaf * problem_.bands + b] * irradiances_[k];
    }
}

void TreeLight::push_to_children(uint32_t node, std::vector<double>& irradiances) const {
  const size_t first = tree_.nodes()[node].children;
  const ShapeBasis& shape = basis_.of(tree_.root(node).triangle);
  for (size_t c = 0; c < 4; ++c)
    for (size_t b = 0; b < problem_.bands; ++b) {
      const double* from = &irradiances[node * per_node_ + b * functions_];
      double* to = &irradiances[(first + c) * per_node_ + b * functions_];
      for (size_t i = 0; i < shape.count; ++i)
        for (size_t j = 0; j < shape.count; ++j) to[j] += from[i] * shape.push[c][i * shape.count + j];
    }
}

/// Over the node's area.
double TreeLight::mean(const std::vector<double>& values, uint32_t node, size_t band) const {
  const double* of = &values[node * per_node_ + band * functions_];
  if (basis_.of(tree_.root(node).triangle).powers.empty()) return (of[0] + of[1] + of[2] + of[3]) / 2;  // boxes
  return of[0];
}

void TreeLight::pull() {
  for (size_t node = tree_.nodes().size(); node-- > 0;) {
    double brightness = 0;
    if (const uint32_t first = tree_.nodes()[node].children; first != TreeNode::kNone) {
      const ShapeBasis& shape = basis_.of(tree_.root(uint32_t(node)).triangle);
      std::fill_n(&radiosities[node * per_node_], per_node_, 0.0);
      for (size_t c = 0; c < 4; ++c)
        for (size_t b = 0; b < problem_.bands; ++b) {
          const double* from = &radiosities[(first + c) * per_node_ + b * functions_];
          double* to = &radiosities[node * per_node_ + b * functions_];
          for (size_t i = 0; i < shape.count; ++i)
            for (size_t j = 0; j < shape.count; ++j) to[i] += shape.pull[c][i * shape.count + j] * from[j];
        }
      for (size_t c = 0; c < 4; ++c) brightness += brightness_[first + c] / 4;
    } else {
      for (size_t b = 0; b < problem_.bands; ++b)
        brightness += problem_.weights[b] * std::max(mean(radiosities, uint32_t(node), b), 0.0);
    }
    brightness_[node] = brightness;
  }
  if (has_importance_) scale_importance();
}

/// What is seen has importance 1 on average, weighted by its share of the picture.
void TreeLight::scale_importance() {
  const size_t band = problem_.bands - 1;
  double sum = 0, seen = 0;
  for (uint32_t node = 0; node < tree_.nodes().size(); ++node) {
    if (!tree_.is_leaf(node)) continue;
    const double own = tree_.area(node) * mean(sources_, node, band);
    sum += own * mean(radiosities, node, band), seen += own;
  }
  importance_.resize(tree_.nodes().size());
  for (uint32_t node = 0; node < tree_.nodes().size(); ++node)
    importance_[node] = seen > 0 ? std::clamp(mean(radiosities, node, band) * seen / sum, 0.0, 1.0) : 1;
}

void TreeLight::push_and_pull(std::span<const double> gathered) {
  before_ = std::move(irradiances_);
  irradiances_.assign(gathered.begin(), gathered.end());
  for (uint32_t node = 0; node < tree_.nodes().size(); ++node)
    if (tree_.is_leaf(node))
      reflect(node);
    else
      push_to_children(node, irradiances_);
  pull();
}

void TreeLight::emit_only() {
  radiosities = emitted_;
  pull();
}

std::vector<double> TreeLight::receivers(const std::vector<double>& irradiances) const {
  const size_t stride = problem_.bands, bands = stride - (has_importance_ ? 1 : 0);
  std::vector<double> sums(problem_.size() * bands, 0);
  for (uint32_t node = 0; node < tree_.nodes().size(); ++node) {
    if (!tree_.is_leaf(node) || tree_.overlaps(node).empty()) continue;
    const double scale = tree_.area(node) / double(tree_.nodes()[node].covered);
    for (const SurfaceTree::Overlap& each : tree_.overlaps(node)) {
      const std::vector<double> part = moments(node, each);
      for (size_t b = 0; b < bands; ++b)
        for (size_t i = 0; i < part.size(); ++i)
          sums[each.receiver * bands + b] += scale * part[i] * irradiances[node * per_node_ + b * functions_ + i];
    }
  }
  for (size_t k = 0; k < sums.size(); ++k) {
    sums[k] = std::max(sums[k], 0.0) / problem_.areas[k / bands];
    if (!problem_.arriving.empty()) sums[k] += problem_.arriving[k / bands * stride + k % bands];
  }
  return sums;
}

}  // namespace aktina
