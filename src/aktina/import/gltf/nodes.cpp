#include "aktina/import/gltf/nodes.h"

#include <fmt/format.h>

#include <cmath>

namespace aktina::gltf {
namespace {

Mat4 local_transform(const Value& node) {
  float m[16];
  if (node["matrix"].numbers(m)) {
    Mat4 out;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) out[c][r] = m[c * 4 + r];
    out[0][3] = out[1][3] = out[2][3] = 0, out[3][3] = 1;  // affine by definition
    return out;
  }
  float t[] = {0, 0, 0}, q[] = {0, 0, 0, 1}, s[] = {1, 1, 1};
  node["translation"].numbers(t), node["rotation"].numbers(q), node["scale"].numbers(s);
  return compose({t[0], t[1], t[2]}, {q[0], q[1], q[2], q[3]}, {s[0], s[1], s[2]});
}

/// Parent of every node of the file; -1 of roots.
std::vector<int> find_parents(const Value& nodes) {
  std::vector<int> parents(nodes.size(), -1);
  for (size_t i = 0; i < nodes.size(); ++i) {
    const Value children = nodes[i]["children"];
    for (size_t k = 0; k < children.size(); ++k) {
      const int child = children[k].index(nodes.size());
      if (parents[size_t(child)] >= 0)
        children[k].fail(fmt::format("node {} is also a child of node {}", child, parents[size_t(child)]));
      parents[size_t(child)] = int(i);
    }
  }
  return parents;
}

/// Every chain of parents ends: no node is its own ancestor.
void check_cycles(const Value& nodes, const std::vector<int>& parents) {
  std::vector<int> chain(parents.size(), -1);  // on which walk a node was met first
  for (size_t start = 0; start < parents.size(); ++start)
    for (int i = int(start); i >= 0 && chain[size_t(i)] != int(start); i = parents[size_t(i)]) {
      if (chain[size_t(i)] >= 0) break;
      chain[size_t(i)] = int(start);
      if (parents[size_t(i)] >= 0 && chain[size_t(parents[size_t(i)])] == int(start))
        nodes[size_t(i)].fail("is its own ancestor: the nodes form a cycle");
    }
}

/// Roots of the scene that is shown: the file's default, else its first, else all nodes without a parent.
std::vector<int> find_roots(Document& document, const std::vector<int>& parents) {
  const Value scenes = document.list("scenes");
  std::vector<int> roots;
  if (scenes.size() == 0) {
    for (size_t i = 0; i < parents.size(); ++i)
      if (parents[i] < 0) roots.push_back(int(i));
    if (!parents.empty()) document.warnings.add("the file has no scene: all its nodes are shown");
    return roots;
  }
  const int chosen = std::max(document.root()["scene"].index(scenes.size()), 0);
  if (scenes.size() > 1) document.warnings.add("of several scenes in the file one is shown", scenes.size());
  const Value list = scenes[size_t(chosen)]["nodes"];
  std::vector<bool> seen(parents.size(), false);
  for (size_t i = 0; i < list.size(); ++i) {
    const int root = list[i].index(parents.size());
    if (parents[size_t(root)] >= 0) list[i].fail("is a child of another node, not a root");
    if (seen[size_t(root)]) list[i].fail("stands in the list twice");
    seen[size_t(root)] = true;
    roots.push_back(root);
  }
  return roots;
}

}  // namespace

Mat4 compose(Vec3 translation, Vec4 rotation, Vec3 scale) {
  const float norm = dot(rotation, rotation);
  const Vec4 q = norm > 0 && norm < kInfinity ? rotation * (1 / std::sqrt(norm)) : Vec4(0, 0, 0, 1);
  const float x = q.x, y = q.y, z = q.z, w = q.w;
  Mat4 m(1);
  m[0] = Vec4(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0) * scale.x;
  m[1] = Vec4(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0) * scale.y;
  m[2] = Vec4(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0) * scale.z;
  m[3] = Vec4(translation, 1);
  return m;
}

Mat4 rigid(const Mat4& m) {
  const Vec3 z = normalize_or(Vec3(m[2]), {0, 0, 1});
  const Vec3 up = Vec3(m[1]) - z * dot(z, Vec3(m[1]));
  const Vec3 y = normalize_or(up, Frame(z).b);
  return Mat4(Vec4(cross(y, z), 0), Vec4(y, 0), Vec4(z, 0), m[3]);
}

Hierarchy read_nodes(Document& document, Scene& scene) {
  const Value nodes = document.list("nodes");
  const std::vector<int> parents = find_parents(nodes);
  check_cycles(nodes, parents);
  Hierarchy out;
  document.allowance.take(nodes.size() * sizeof(Node), nodes);
  struct Waiting {
    int source, parent;  // numbers in the file and in the scene
  };
  std::vector<Waiting> waiting;
  const std::vector<int> roots = find_roots(document, parents);
  Mat4 units(1);
  if (document.options.metres_per_unit > 0) {
    scene.metres_per_unit = document.options.metres_per_unit;
    for (int k = 0; k < 3; ++k) units[k][k] = float(scene.metres_per_unit);
  }
  for (size_t i = roots.size(); i-- > 0;) waiting.push_back({roots[i], -1});
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    const Value place = nodes[size_t(next.source)];
    if (!place.extension("KHR_node_visibility")["visible"].flag(true)) continue;  // with all below it
    Node node{place["name"].text(), next.parent, local_transform(place)};
    if (next.parent < 0) node.local = units * node.local;
    node.to_world = next.parent < 0 ? node.local : scene.nodes[size_t(next.parent)].to_world * node.local;
    const Value children = place["children"];
    for (size_t k = children.size(); k-- > 0;)
      waiting.push_back({children[k].index(nodes.size()), int(scene.nodes.size())});
    scene.nodes.push_back(std::move(node));
    out.source.push_back(next.source);
  }
  return out;
}

}  // namespace aktina::gltf
