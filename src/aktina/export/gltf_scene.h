// Nodes, meshes, cameras and lights of a scene -> glTF.
#pragma once

#include <functional>

#include "aktina/export/gltf_file.h"
#include "aktina/scene/scene.h"

namespace aktina::gltf_export {

/// Writes the hierarchy with what hangs on it. Instances must be of meshes. A matrix that glTF cannot express (sheared,
/// flattened) is applied to the vertices instead.
/// @param material_of  glTF material of an instance, -1: none
void add_nodes(GltfFile& file, const Scene& scene, const std::function<int(const Instance&)>& material_of);

}  // namespace aktina::gltf_export
