// Meshes of a file -> Scene::meshes, one for each of their primitives.
#pragma once

#include <vector>

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {

/// Indices into Scene::meshes for each mesh of the file; primitives without triangles have none.
using MeshTable = std::vector<std::vector<int>>;

/// Reads the meshes that `used` names (by index). Materials are read before: normal maps need tangents.
MeshTable read_meshes(Document& document, const std::vector<bool>& used, Scene& scene);

/// Triangles of vertices taken in order by mode 4 (list), 5 (strip), 6 (fan); indices that complete none are dropped.
std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<uint32_t>& vertices, uint64_t mode);

}  // namespace aktina::gltf
