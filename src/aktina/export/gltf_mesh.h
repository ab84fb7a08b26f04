// A mesh -> a glTF mesh primitive.
#pragma once

#include "aktina/export/gltf_file.h"
#include "aktina/scene/mesh.h"

namespace aktina::gltf_export {

/// Positions, normals, tangents, two texture coordinate sets, colours (clamped to [0, 1], as glTF demands) and indices.
Json primitive_json(GltfFile& file, const Mesh& mesh);

/// The mesh moved by any matrix, fronts kept.
Mesh transformed(const Mesh& mesh, const Mat4& to_world);

}  // namespace aktina::gltf_export
