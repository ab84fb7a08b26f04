#include "aktina/radiosity/mesher/quadtree_forest.h"

#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

size_t count_edges(const PatchBuilder::Corners& c) { return c[2] != c[3] ? 4 : 3; }
uint64_t key(uint32_t a, uint32_t b) { return (uint64_t(std::min(a, b)) << 32) | std::max(a, b); }

/// The values of a mesh's patch as the next ones of another.
void copy_patch(const PatchMesh& from, size_t patch, PatchMesh& to) {
  to.patches.push_back(from.patches[patch]);
  to.centres.push_back(from.centres[patch]);
  to.areas.push_back(from.areas[patch]);
  to.patch_normals.push_back(from.patch_normals[patch]);
  to.reflectances.push_back(from.reflectances[patch]);
  to.transmittances.push_back(from.transmittances[patch]);
  to.emissions.push_back(from.emissions[patch]);
  to.two_sided.push_back(from.two_sided[patch]);
}

/// Moves the patches out of a mesh; its vertices stay.
PatchMesh take_patches(PatchMesh& mesh) {
  PatchMesh old = std::move(mesh);
  mesh = {};
  mesh.positions = std::move(old.positions);
  mesh.normals = std::move(old.normals);
  mesh.places = std::move(old.places);
  return old;
}

}  // namespace

QuadtreeForest::QuadtreeForest(const Scene& scene, PatchMesh mesh, uint64_t most)
    : mesh_(std::move(mesh)), faces_(scene), builder_(mesh_, scene, most), most_(most), shooters_(mesh_.shooters) {
  places_ = weld(mesh_.positions);
  find_faces();
  nodes_.reserve(mesh_.size()), leaf_of_.reserve(mesh_.size());
  for (uint32_t i = 0; i < mesh_.size(); ++i) {
    nodes_.push_back({.corners = mesh_.patches[i], .root = i, .patches = i, .count = 1});
    leaf_of_.push_back(i);
  }
}

/// Which face each root is a part of.
void QuadtreeForest::find_faces() {
  std::unordered_map<uint64_t, Root> of_triangle;
  for (uint32_t k = 0; k < faces_.faces.size(); ++k)
    for (const SourceFace& face : faces_.faces[k].list)
      for (const uint32_t triangle : face.triangles)
        of_triangle[uint64_t(faces_.instances[k]) << 32 | triangle] = {k, &face};
  roots_.reserve(mesh_.size());
  for (const SurfacePoint& c : mesh_.centres) roots_.push_back(of_triangle.at(uint64_t(c.instance) << 32 | c.triangle));
}

uint64_t QuadtreeForest::edge(uint32_t a, uint32_t b) const { return key(places_[a], places_[b]); }

uint8_t QuadtreeForest::split_edges(const Corners& c) const {
  uint8_t bits = 0;
  const size_t n = count_edges(c);
  for (size_t k = 0; k < n; ++k) bits |= uint8_t(middle_places_.count(edge(c[k], c[(k + 1) % n])) << k);
  return bits;
}

/// What is added next belongs to this node.
void QuadtreeForest::enter(const Node& node) {
  const Root& root = roots_[node.root];
  if (entered_ != root.of_faces) builder_.begin(faces_.instances[root.of_faces], faces_.faces[root.of_faces]);
  entered_ = root.of_faces, face_ = root.face;
}

uint32_t QuadtreeForest::add_vertex(Point3 p, uint32_t place) {
  const uint32_t vertex = builder_.add_vertex(*face_, p);
  places_.push_back(place == kNone ? vertex : place);
  return vertex;
}

/// In the middle of an edge, which counts as split from now on. Neighbours find the same place.
uint32_t QuadtreeForest::middle(uint32_t a, uint32_t b) {
  if (const auto at = middles_.find(key(a, b)); at != middles_.end()) return at->second;
  const auto place = middle_places_.find(edge(a, b));
  const Point3 p = 0.5f * (mesh_.positions[a] + mesh_.positions[b]);
  const uint32_t vertex = add_vertex(p, place == middle_places_.end() ? kNone : place->second);
  middle_places_.try_emplace(edge(a, b), places_[vertex]);
  return middles_[key(a, b)] = vertex;
}

void QuadtreeForest::split(size_t index) {
  enter(nodes_[index]);
  const Corners c = nodes_[index].corners;
  const size_t n = count_edges(c);
  std::array<uint32_t, 4> m;
  for (size_t k = 0; k < n; ++k) m[k] = middle(c[k], c[(k + 1) % n]);
  std::array<Corners, 4> children;
  if (n == 4) {
    const auto& p = mesh_.positions;
    const uint32_t o = add_vertex(0.25f * (p[c[0]] + p[c[1]] + p[c[2]] + p[c[3]]), kNone);
    children = {{{c[0], m[0], o, m[3]}, {m[0], c[1], m[1], o}, {o, m[1], c[2], m[2]}, {m[3], o, m[2], c[3]}}};
  } else {
    children = {
        {{c[0], m[0], m[2], m[2]}, {m[0], c[1], m[1], m[1]}, {m[2], m[1], c[2], c[2]}, {m[0], m[1], m[2], m[2]}}};
  }
  nodes_[index].children = uint32_t(nodes_.size());
  const Node parent = nodes_[index];
  for (const Corners& child : children)
    nodes_.push_back({.corners = child, .root = parent.root, .level = uint8_t(parent.level + 1)});
}

/// Half of an edge is split: the neighbour there is smaller by two levels. Or all edges are: anchors would be as many
/// as corners.
bool QuadtreeForest::must_split(const Corners& c) const {
  const size_t n = count_edges(c);
  const uint8_t edges = split_edges(c);
  if (edges == (1U << n) - 1) return true;
  for (size_t k = 0; k < n; ++k) {
    if (!(edges >> k & 1)) continue;
    const uint32_t a = places_[c[k]], b = places_[c[(k + 1) % n]], m = middle_places_.at(key(a, b));
    if (middle_places_.count(key(a, m)) || middle_places_.count(key(m, b))) return true;
  }
  return false;
}

void QuadtreeForest::balance() {
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < nodes_.size(); ++i)
      if (nodes_[i].children == kNone && must_split(nodes_[i].corners)) split(i), changed = true;
  }
}

std::vector<uint32_t> QuadtreeForest::refine(std::span<const uint8_t> marks, int depth) {
  const size_t before = nodes_.size();
  for (size_t i = 0; i < marks.size(); ++i) {
    const Node& leaf = nodes_[leaf_of_[i]];
    if (marks[i] && leaf.children == kNone && leaf.level < depth) split(leaf_of_[i]);
  }
  if (nodes_.size() == before) return {};
  balance();
  return rebuild();
}

std::vector<uint32_t> QuadtreeForest::rebuild() {
  std::vector<uint32_t> origin, open;
  const PatchMesh old = take_patches(mesh_);
  leaf_of_.clear();
  for (const PatchMesh::Shooter& shooter : shooters_) {
    mesh_.shooters.push_back({uint32_t(mesh_.size()), 0, shooter.corners});
    for (uint32_t root = shooter.first; root < shooter.first + shooter.count; ++root) {
      open.push_back(root);
      while (!open.empty()) {
        const uint32_t i = open.back();
        open.pop_back();
        if (nodes_[i].children == kNone)
          add_leaf(i, old, origin);
        else
          for (uint32_t k = 4; k-- > 0;) open.push_back(nodes_[i].children + k);
      }
    }
    mesh_.shooters.back().count = uint32_t(mesh_.size()) - mesh_.shooters.back().first;
  }
  return origin;
}

void QuadtreeForest::add_leaf(uint32_t index, const PatchMesh& old, std::vector<uint32_t>& origin) {
  const uint8_t anchors = split_edges(nodes_[index].corners);
  const uint32_t first = uint32_t(mesh_.size());
  const Node leaf = nodes_[index];
  const bool kept = leaf.count > 0 && leaf.anchors == anchors;
  if (kept) {
    for (uint32_t i = leaf.patches; i < leaf.patches + leaf.count; ++i) copy_patch(old, i, mesh_), origin.push_back(i);
  } else {
    enter(leaf);
    add_patches(leaf.corners, anchors);
    origin.resize(mesh_.size(), kNew);
  }
  nodes_[index].anchors = anchors;
  nodes_[index].patches = first, nodes_[index].count = uint32_t(mesh_.size()) - first;
  leaf_of_.resize(mesh_.size(), index);
  if (mesh_.size() > most_)
    throw Error(Code::limit, "most_patches", fmt::format("the scene needs more than {} patches", most_),
                "a larger patch size, fewer levels, or a higher limit");
}

/// A leaf as patches that have the anchors for corners.
void QuadtreeForest::add_patches(const Corners& c, uint8_t anchors) {
  if (anchors == 0) return builder_.add_patch(*face_, c);
  const size_t n = count_edges(c);
  size_t first = 0;  // so that what is anchored comes first, one after the other where it can
  const auto anchored = [&](size_t k) { return (anchors >> (k % n) & 1) != 0; };
  while (!(anchored(first) && !anchored(first + n - 1))) ++first;
  const auto corner = [&](size_t k) { return c[(first + k) % n]; };
  const auto anchor = [&](size_t k) { return middle(corner(k), corner(k + 1)); };
  const auto triangle = [&](uint32_t p, uint32_t q, uint32_t r) { builder_.add_patch(*face_, {p, q, r, r}); };
  const auto quad = [&](uint32_t p, uint32_t q, uint32_t r, uint32_t s) { builder_.add_patch(*face_, {p, q, r, s}); };
  const uint32_t p = corner(0), q = corner(1), r = corner(2), m = anchor(0);
  const bool second = anchored(first + 1), third = n == 4 && anchored(first + 2);
  if (n == 3) {
    if (!second) return triangle(p, m, r), triangle(m, q, r);
    return triangle(m, q, anchor(1)), quad(p, m, anchor(1), r);
  }
  const uint32_t s = corner(3);
  if (second && third)
    return triangle(m, q, anchor(1)), triangle(anchor(1), r, anchor(2)), triangle(m, anchor(1), anchor(2)),
           quad(p, m, anchor(2), s);
  if (second) return triangle(m, q, anchor(1)), triangle(p, m, s), triangle(m, anchor(1), s), triangle(anchor(1), r, s);
  if (third) return quad(p, m, anchor(2), s), quad(m, q, r, anchor(2));
  return triangle(p, m, s), triangle(m, q, r), triangle(m, r, s);
}

}  // namespace aktina
