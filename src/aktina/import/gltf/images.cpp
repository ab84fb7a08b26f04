// Pictures: within the file or beside it.
#include <algorithm>

#include "aktina/import/gltf/materials.h"

namespace aktina::gltf {
namespace {

std::vector<uint8_t> encoded_bytes(Document& document, const Value& image) {
  if (image["uri"]) return fetch(document, image["uri"]);
  const int view = image["bufferView"].index(document.list("bufferViews").size());
  if (view < 0) image.fail("has neither a uri nor a bufferView");
  const auto bytes = document.view(size_t(view));
  document.allowance.take(bytes.size(), image);
  return {bytes.begin(), bytes.end()};
}

TextureImage read_image(Document& document, const Value& place) {
  TextureImage out;
  out.name = place["name"].text();
  if (place["uri"] && !place["uri"].text_view().starts_with("data:")) out.uri = place["uri"].text();
  try {
    out.encoded = encoded_bytes(document, place);
  } catch (const Error& error) {
    if (error.code() == Code::limit) throw;
    document.warnings.add("a picture is missing or broken, and taken as white: " + std::string(error.what()));
    out.pixels = Bitmap{1, 1, 4, false, {255, 255, 255, 255}};
  }
  return out;
}

}  // namespace

void read_images(Document& document, Scene& scene) {
  const Value list = document.list("images");
  for (size_t i = 0; i < list.size(); ++i) scene.images.push_back(read_image(document, list[i]));
}

}  // namespace aktina::gltf
