// KHR_draco_mesh_compression: a primitive's indices and attributes in one packed buffer view.
#pragma once

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {

/// Triangles and the attributes that Aktina reads. @param primitive  with the extension
/// @throws Error bad_input, limit
Mesh unpack_draco(Document& document, const Value& primitive);

}  // namespace aktina::gltf
