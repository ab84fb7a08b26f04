// A mesh whose patches can be split into four, again and again: quadtrees, one for each patch that there was first.
#pragma once

#include <unordered_map>

#include "aktina/radiosity/mesher/patch_builder.h"

namespace aktina {

/// Restricted quadtrees: along an edge the leaves of neighbours differ by one level at most, of other instances too.
/// Where they do, the larger one takes the middle of the edge for a corner (it is anchored) and becomes triangles and
/// quadrilaterals: patches always share their corners, there are neither T-junctions nor cracks.
/// Triangles split into four at the middles of their edges, quadrilaterals by the lines between those.
/// D. Baum, S. Mann, K. Smith, J. Winget, "Making Radiosity Usable: Automatic Preprocessing and Meshing Techniques for
/// the Generation of Accurate Radiosity Solutions", SIGGRAPH 1991; restricted: B. Von Herzen, A. Barr, "Accurate
/// Triangulations of Deformed, Intersecting Surfaces", SIGGRAPH 1987.
class QuadtreeForest {
 public:
  static constexpr uint32_t kNew = 0xffffffff;

  /// @param scene  that `mesh` is of; must outlive this
  /// @param mesh   by any mesher; its patches are the roots
  /// @param most   patches that it may come to have
  QuadtreeForest(const Scene& scene, PatchMesh mesh, uint64_t most);

  const PatchMesh& mesh() const { return mesh_; }
  PatchMesh take() && { return std::move(mesh_); }

  /// Splits the leaves that marked patches belong to, unless they are of level `depth`, and what must be split with
  /// them. What shoots together stays the same, with the same corners; so do vertices, to which others are added.
  /// @param marks  by patch of mesh(): not 0 where it is to be split
  /// @return  by patch of the mesh as it is then: what it was before, if it is unchanged; else kNew. Empty: all stay
  /// @throws Error limit (more than `most` patches)
  std::vector<uint32_t> refine(std::span<const uint8_t> marks, int depth);

 private:
  using Corners = PatchBuilder::Corners;
  static constexpr uint32_t kNone = 0xffffffff;
  struct Node {
    Corners corners;
    uint32_t root;
    uint8_t level = 0;
    uint8_t anchors = 0;              // edges whose middles are corners of its patches: a bit each
    uint32_t children = kNone;        // the first of four
    uint32_t patches = 0, count = 0;  // of a leaf, in the mesh as it was last built
  };
  struct Root {
    uint32_t of_faces;  // in faces_
    const SourceFace* face;
  };

  void find_faces();
  uint64_t edge(uint32_t a, uint32_t b) const;
  uint8_t split_edges(const Corners& corners) const;
  void enter(const Node& node);
  uint32_t add_vertex(Point3 p, uint32_t place);
  uint32_t middle(uint32_t a, uint32_t b);
  void split(size_t node);
  bool must_split(const Corners& corners) const;
  void balance();
  std::vector<uint32_t> rebuild();
  void add_leaf(uint32_t leaf, const PatchMesh& old, std::vector<uint32_t>& origin);
  void add_patches(const Corners& corners, uint8_t anchors);

  PatchMesh mesh_;
  SceneFaces faces_;
  PatchBuilder builder_;
  uint64_t most_;
  std::vector<Root> roots_;                               // the first mesh's patches
  std::vector<PatchMesh::Shooter> shooters_;              // in roots
  std::vector<Node> nodes_;                               // the roots first
  std::vector<uint32_t> leaf_of_;                         // of each patch
  std::vector<uint32_t> places_;                          // of each vertex: the first one in its place
  std::unordered_map<uint64_t, uint32_t> middle_places_;  // of edges between places that were split
  std::unordered_map<uint64_t, uint32_t> middles_;        // of edges between vertices
  uint32_t entered_ = kNone;                              // whose instance the builder builds
  const SourceFace* face_ = nullptr;
};

}  // namespace aktina
