// Pictures: within the file or beside it, decoded to what textures look up.
#include <algorithm>

#include "aktina/base/parallel.h"
#include "aktina/image/file_format.h"
#include "aktina/import/gltf/materials.h"

namespace aktina::gltf {
namespace {

constexpr size_t kMostNamed = 20;     // broken pictures that are named; the rest is counted
constexpr size_t kMostFaults = 1000;  // after so many the rest is not looked for

std::string media_type(ImageFormat format) {
  switch (format) {
    case ImageFormat::png:
      return "image/png";
    case ImageFormat::jpeg:
      return "image/jpeg";
    case ImageFormat::webp:
      return "image/webp";
    case ImageFormat::hdr:
      return "image/vnd.radiance";
    case ImageFormat::exr:
      return "image/x-exr";
    default:
      return {};
  }
}

std::vector<uint8_t> encoded_bytes(Document& document, const Value& image) {
  if (image["uri"]) return fetch(document, image["uri"]);
  const int view = image["bufferView"].index(document.list("bufferViews").size());
  if (view < 0) image.fail("has neither a uri nor a bufferView");
  const auto bytes = document.view(size_t(view));
  document.allowance.take(bytes.size(), image);
  return {bytes.begin(), bytes.end()};
}

std::vector<bool> used_images(const Scene& scene, size_t count) {
  std::vector<bool> used(count, false);
  for (const Material& m : scene.materials)
    for (const Texture* t :
         {&m.base_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.occlusion_texture, &m.emission_texture,
          &m.transmission_texture, &m.specular_texture, &m.specular_tint_texture})
      if (*t) used[size_t(t->image)] = true;
  return used;
}

class ImageReader {
 public:
  ImageReader(Document& document, Scene& scene)
      : document_(document), list_(document.list("images")), scene_(scene), used_(used_images(scene, list_.size())) {}

  void run() {
    faults_.resize(list_.size());
    for (size_t i = 0; i < list_.size(); ++i) read_encoded(i);
    parallel_for(list_.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) decode(i);
    });
    report();
  }

 private:
  /// Runs `body`; a fault that leaves a white picture is kept for later.
  template <class Body>
  void guarded(size_t i, const Body& body) {
    try {
      body();
    } catch (const Error& error) {
      if (error.code() == Code::limit) throw;
      faults_[i] = error.message();
    }
  }

  std::string place(size_t i) const { return document_.root().place() + " /images/" + std::to_string(i); }

  void read_encoded(size_t i) {
    const Value source = list_[i];
    TextureImage& image = scene_.images.emplace_back();
    image.name = source["name"].text();
    if (source["uri"] && !source["uri"].text_view().starts_with("data:")) image.uri = source["uri"].text();
    if (faulty_ >= kMostFaults) {
      faults_[i] = "not looked for after so many";
      return;
    }
    guarded(i, [&] {
      image.encoded = encoded_bytes(document_, source);
      const ImageHeader header = read_image_header(image.encoded, place(i));
      image.media_type = media_type(header.format);
      const bool bitmap = !image.media_type.ends_with("radiance") && !image.media_type.ends_with("exr");
      if (used_[i])
        document_.allowance.take(uint64_t(header.width) * uint64_t(header.height) * (bitmap ? 4 : 16), source);
    });
    faulty_ += faults_[i].empty() ? 0 : 1;
  }

  void decode(size_t i) {
    if (!used_[i] || !faults_[i].empty()) return;
    TextureImage& image = scene_.images[i];
    guarded(i, [&] { image.pixels = decode_texture(image.encoded, place(i)); });
  }

  void report() {
    size_t named = 0;
    for (size_t i = 0; i < faults_.size(); ++i) {
      if (faults_[i].empty()) continue;
      scene_.images[i].pixels = Bitmap{1, 1, 4, false, {255, 255, 255, 255}};
      std::string text = "pictures are missing or broken, and taken as white";
      if (++named <= kMostNamed) text += ": /images/" + std::to_string(i) + ": " + faults_[i];
      document_.warnings.add(text);
    }
  }

  Document& document_;
  Value list_;
  Scene& scene_;
  std::vector<bool> used_;
  std::vector<std::string> faults_;
  size_t faulty_ = 0;
};

}  // namespace

void read_images(Document& document, Scene& scene) { ImageReader(document, scene).run(); }

}  // namespace aktina::gltf
