#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "aktina/import/assimp/build.h"

namespace aktina::assimp {
namespace {

constexpr float kLargestExponent = 1e6f;

float within(float value, float low, float high, float fallback) {
  return std::isfinite(value) ? std::clamp(value, low, high) : fallback;
}
Rgb share(Vec3 c) { return {within(c.x, 0, 1, 0), within(c.y, 0, 1, 0), within(c.z, 0, 1, 0)}; }

class MaterialBuilder {
 public:
  MaterialBuilder(const Document& document, Beside& beside, Scene& scene)
      : document_(document), beside_(beside), scene_(scene) {}

  Material build(const FileMaterial& from) {
    const Texture base = texture(from.diffuse), shining = texture(from.emissive);
    ClassicMaterial classic;
    classic.ka = share(from.ka), classic.kd = share(from.kd), classic.ks = share(from.ks), classic.kr = share(from.kr);
    if (base) classic.ka = classic.kd = Rgb(1);  // the picture takes the colour's place
    classic.exponent = within(from.exponent, 0, kLargestExponent, 1);
    classic.index = within(from.index, 1, 10, 1);
    Material m = material_of(classic);
    m.name = from.name;
    const auto shines = [](float v) { return within(v, 0, 1e9f, 0); };
    m.emission = Radiance(Rgb(shines(from.emission.x), shines(from.emission.y), shines(from.emission.z)));
    m.alpha = within(from.opacity, 0, 1, 1);
    m.double_sided = from.double_sided != 0;
    if (shining && !m.emits()) m.emission = Radiance(Rgb(1));
    m.base_texture = base, m.emission_texture = shining;
    m.normal_texture = texture(from.normal);
    if (m.alpha < 1) m.alpha_mode = AlphaMode::blend;
    add_opacity(from, m);
    return m;
  }

 private:
  /// A picture of opacity is the base picture's own alpha, or becomes it.
  void add_opacity(const FileMaterial& from, Material& m) {
    const Texture opacity = texture(from.alpha);
    if (!opacity) return;
    if (m.base_texture && !same_place(from.alpha, from.diffuse))
      return scene_.warnings.add("pictures of opacity that lie unlike the diffuse one were left out");
    m.alpha_mode = AlphaMode::blend;
    if (opacity.image == m.base_texture.image) return;
    const int image = beside_.with_alpha(scene_, m.base_texture.image, opacity.image);
    if (!m.base_texture) m.base_texture = opacity;
    m.base_texture.image = image;
  }
  static bool same_place(const FileTexture& a, const FileTexture& b) {
    return a.uv_set == b.uv_set && a.offset == b.offset && a.scale == b.scale;
  }

  Texture texture(const FileTexture& from) {
    Texture use;
    use.image = image(from.file);
    if (use.image < 0) return use;
    use.uv_set = from.uv_set == 1 ? 1 : 0;
    const auto number = [](float v, float fallback) { return within(v, -1e6f, 1e6f, fallback); };
    // v runs down here: v' = 1 - (1 - v) s - o
    use.scale = {number(from.scale.x, 1), number(from.scale.y, 1)};
    use.offset = {number(from.offset.x, 0), 1 - use.scale.y - number(from.offset.y, 0)};
    use.wrap_u = wrap(from.wrap_u), use.wrap_v = wrap(from.wrap_v);
    return use;
  }
  static Wrap wrap(uint8_t number) { return number <= uint8_t(Wrap::clamp) ? Wrap(number) : Wrap::repeat; }

  /// "*3" is the fourth picture within the file.
  int image(const std::string& file) {
    if (file.empty()) return -1;
    if (file[0] != '*') return beside_.image(scene_, file);
    size_t number = document_.pictures.size();
    std::from_chars(file.data() + 1, file.data() + file.size(), number);
    if (number >= document_.pictures.size()) return -1;
    const FilePicture& picture = document_.pictures[number];
    return beside_.image(scene_, file + picture.name, picture.bytes);
  }

  const Document& document_;
  Beside& beside_;
  Scene& scene_;
};

}  // namespace

void build_materials(const Document& document, Beside& beside, Scene& scene) {
  MaterialBuilder builder(document, beside, scene);
  for (const FileMaterial& material : document.materials) scene.materials.push_back(builder.build(material));
}

}  // namespace aktina::assimp
