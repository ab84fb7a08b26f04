// The node hierarchy: which nodes are drawn, where they stand, and what hangs on them.
#pragma once

#include <vector>

#include "aktina/import/gltf/document.h"
#include "aktina/import/gltf/meshes.h"

namespace aktina::gltf {

/// Nodes of the scene that is shown, parents before children. `source[i]` is the number in the file of Scene::nodes[i].
struct Hierarchy {
  std::vector<int> source;
};

/// Fills Scene::nodes. Without recursion: a chain of any length is read.
/// @throws Error bad_input (cycles, two parents, children that do not exist)
Hierarchy read_nodes(Document& document, Scene& scene);

/// Camera, lights, meshes and shapes of each node.
void read_cameras(Document& document, const Hierarchy& hierarchy, Scene& scene);
void read_lights(Document& document, const Hierarchy& hierarchy, Scene& scene);
void read_luminaires(Document& document, const Hierarchy& hierarchy, Scene& scene);
void read_instances(Document& document, const Hierarchy& hierarchy, const MeshTable& meshes, Scene& scene);

/// The rotation of a placement, its scale taken away: columns are unit and orthogonal.
Mat4 rigid(const Mat4& to_world);

/// Translation, rotation (quaternion x, y, z, w) and scale.
Mat4 compose(Vec3 translation, Vec4 rotation, Vec3 scale);

}  // namespace aktina::gltf
