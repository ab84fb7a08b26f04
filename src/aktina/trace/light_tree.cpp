#include "aktina/trace/light_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace aktina {
namespace {

constexpr float kHalfTurn = float(kPi);
constexpr uint8_t kAbsent = 255;

float angle(Vec3 a, Vec3 b) { return std::acos(std::clamp(dot(a, b), -1.0f, 1.0f)); }

/// v turned about the unit axis k. Rodrigues' formula.
Vec3 turned(Vec3 v, Vec3 k, float by) {
  const float c = std::cos(by), s = std::sin(by);
  return v * c + cross(k, v) * s + k * (dot(k, v) * (1 - c));
}

/// The smallest cone about both.
void join_cones(LampBounds& a, LampBounds b) {
  if (b.spread > a.spread) std::swap(a.axis, b.axis), std::swap(a.spread, b.spread);
  const float between = angle(a.axis, b.axis);
  if (std::min(between + b.spread, kHalfTurn) <= a.spread) return;
  const float spread = 0.5f * (a.spread + between + b.spread);
  const Vec3 across = cross(a.axis, b.axis);
  if (spread >= kHalfTurn || squared_length(across) < 1e-12f) {
    a.spread = kHalfTurn;
    return;
  }
  a.axis = normalize(turned(a.axis, normalize(across), spread - a.spread));
  a.spread = spread;
}

LampBounds joined(LampBounds a, const LampBounds& b) {
  join_cones(a, b);
  a.box.add(b.box);
  a.power += b.power;
  a.beam = std::max(a.beam, b.beam);
  return a;
}

}  // namespace

void LightTree::build(std::vector<LampBounds> lamps) {
  nodes_.clear();
  path_.assign(lamps.size(), 0);
  depth_.assign(lamps.size(), kAbsent);
  std::vector<uint32_t> order;
  for (uint32_t i = 0; i < lamps.size(); ++i)
    if (lamps[i].power > 0 && lamps[i].power < kInfinity && !lamps[i].box.empty()) order.push_back(i);
  LampBounds all;
  if (!order.empty()) add(lamps, order, 0, order.size(), 0, 0, all);
}

uint32_t LightTree::add(std::vector<LampBounds>& lamps, std::vector<uint32_t>& order, size_t first, size_t last,
                        uint64_t path, int depth, LampBounds& bounds) {
  const auto index = uint32_t(nodes_.size());
  nodes_.emplace_back();
  uint32_t right = 0;
  if (last - first == 1) {
    bounds = lamps[order[first]];
    path_[order[first]] = path, depth_[order[first]] = uint8_t(depth);
  } else {
    Bounds centres;
    for (size_t i = first; i < last; ++i) centres.add(lamps[order[i]].box.centre());
    const Vec3 size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const size_t middle = (first + last) / 2;
    const auto at = [&](size_t i) { return order.begin() + std::ptrdiff_t(i); };
    std::nth_element(at(first), at(middle), at(last), [&](uint32_t a, uint32_t b) {
      const float ca = lamps[a].box.centre()[axis], cb = lamps[b].box.centre()[axis];
      return ca != cb ? ca < cb : a < b;
    });
    LampBounds other;
    add(lamps, order, first, middle, path, depth + 1, bounds);
    right = add(lamps, order, middle, last, path | uint64_t(1) << depth, depth + 1, other);
    bounds = joined(bounds, other);
  }
  Node& node = nodes_[index];
  node.centre = bounds.box.centre();
  node.squared_radius = 0.25f * squared_length(bounds.box.size());
  node.power = bounds.power;
  node.axis = bounds.axis;
  node.cos_spread = std::cos(bounds.spread), node.sin_spread = std::sin(bounds.spread);
  node.cos_beam = std::cos(std::min(bounds.beam, kHalfTurn));
  node.right = right;
  node.lamp = order[first];
  return index;
}

/// Power over squared distance, times the cosine by which the lamp that faces x best can shine there.
float LightTree::importance(const Node& node, Point3 x) {
  const Vec3 d = x - node.centre;
  const float d2 = squared_length(d), near = std::max(d2, node.squared_radius);
  float cosine = 1;
  if (d2 > node.squared_radius) {
    // The angle between axis and direction, less the spread of the normals, less what the box covers.
    const float cos_axis = dot(node.axis, d) / std::sqrt(d2);
    const float sin_axis = std::sqrt(std::max(0.0f, 1 - cos_axis * cos_axis));
    const float sin_box = std::sqrt(node.squared_radius / d2), cos_box = std::sqrt(1 - node.squared_radius / d2);
    const float cos_margin = node.cos_spread * cos_box - node.sin_spread * sin_box;
    const float sin_margin = node.sin_spread * cos_box + node.cos_spread * sin_box;
    const bool within = cos_axis >= cos_margin || sin_margin < 0;
    if (!within) cosine = cos_axis * cos_margin + sin_axis * sin_margin;
    if (cosine < node.cos_beam) return 0;
    // Where lamps shine beyond a right angle (points, two-sided surfaces) the cosine says little.
    cosine = node.cos_beam < -0.01f ? 1 : std::max(cosine, 0.0f);
  }
  return node.power * cosine / std::max(near, 1e-20f);
}

float LightTree::left_share(uint32_t node, Point3 x) const {
  const float left = importance(nodes_[node + 1], x), right = importance(nodes_[nodes_[node].right], x);
  return left + right > 0 ? left / (left + right) : 0.5f;
}

LightTree::Choice LightTree::pick(Point3 x, float u) const {
  uint32_t node = 0;
  float chance = 1;
  while (nodes_[node].right != 0) {
    const float left = left_share(node, x);
    if (u < left) {
      u /= left, chance *= left;
      ++node;
    } else {
      u = (u - left) / (1 - left), chance *= 1 - left;
      node = nodes_[node].right;
    }
  }
  return {nodes_[node].lamp, chance};
}

float LightTree::chance(Point3 x, uint32_t lamp) const {
  if (depth_[lamp] == kAbsent) return 0;
  uint32_t node = 0;
  float chance = 1;
  for (int k = 0; k < depth_[lamp]; ++k) {
    const float left = left_share(node, x);
    const bool to_right = path_[lamp] >> k & 1;
    chance *= to_right ? 1 - left : left;
    node = to_right ? nodes_[node].right : node + 1;
  }
  return chance;
}

}  // namespace aktina
