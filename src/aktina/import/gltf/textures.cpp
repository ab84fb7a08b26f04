// Textures and samplers.
#include "aktina/import/gltf/materials.h"

namespace aktina::gltf {
namespace {

constexpr uint64_t kClamp = 33071, kMirror = 33648, kRepeat = 10497, kNearest = 9728;

Wrap wrap_of(Document& document, const Value& value) {
  const uint64_t mode = value.whole(kRepeat);
  if (mode == kClamp) return Wrap::clamp;
  if (mode == kMirror) return Wrap::mirror;
  if (mode != kRepeat) document.warnings.add("samplers with an unknown way of wrapping repeat");
  return Wrap::repeat;
}

void read_sampler(Document& document, const Value& sampler, Texture& out) {
  out.wrap_u = wrap_of(document, sampler["wrapS"]), out.wrap_v = wrap_of(document, sampler["wrapT"]);
  out.filter = sampler["magFilter"].whole(0) == kNearest ? Filter::nearest : Filter::bilinear;
}

/// The picture itself, or that of an extension for another format.
int image_of(Document& document, const Value& texture) {
  const size_t images = document.list("images").size();
  const int webp = texture.extension("EXT_texture_webp")["source"].index(images);
  const int source = webp >= 0 ? webp : texture["source"].index(images);
  if (source < 0) document.warnings.add("textures without a picture that Aktina reads were taken as white");
  return source;
}

}  // namespace

Texture read_texture(Document& document, const Value& info) {
  Texture out;
  if (!info) return out;
  const Value list = document.list("textures");
  const int index = info["index"].index(list.size());
  if (index < 0) info["index"].fail("is missing");
  const Value texture = list[size_t(index)], transform = info.extension("KHR_texture_transform");
  out.image = image_of(document, texture);
  const Value samplers = document.list("samplers");
  const int sampler = texture["sampler"].index(samplers.size());
  if (sampler >= 0) read_sampler(document, samplers[size_t(sampler)], out);
  out.offset = transform["offset"].vec2(Vec2(0)), out.scale = transform["scale"].vec2(Vec2(1));
  out.rotation = transform["rotation"].real(0);
  const uint64_t set = transform["texCoord"].whole(info["texCoord"].whole(0));
  if (set > 1) document.warnings.add("textures that use a third set of texture coordinates use the first one");
  out.uv_set = set == 1 ? 1 : 0;
  return out;
}

}  // namespace aktina::gltf
