// Materials, textures and images of a file.
#pragma once

#include "aktina/import/gltf/document.h"

namespace aktina::gltf {

/// Scene::images, in the file's order. Pictures that cannot be read are white, with a warning.
void read_images(Document& document, Scene& scene);

/// A textureInfo: image, set of texture coordinates, wrapping, filter, KHR_texture_transform. None where nothing
/// stands.
Texture read_texture(Document& document, const Value& info);

/// Scene::materials, in the file's order.
void read_materials(Document& document, Scene& scene);

}  // namespace aktina::gltf
