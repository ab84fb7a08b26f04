// Materials of an MTL file -> classic coefficients (docs/materials.md, docs/input.md), with the widespread extensions
// for emission (Ke) and metallic-roughness (Pr, Pm).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "aktina/base/error.h"
#include "aktina/import/obj/obj.h"
#include "aktina/import/text.h"

namespace aktina::obj {
namespace {

constexpr float kLargestExponent = 1e6f;

/// A map_ statement: its options and its file.
struct Map {
  std::string file;
  Vec2 offset{0}, scale{1};
  bool clamp = false;
  float bump = 1;
};

/// One newmtl as the file states it.
struct Statement {
  std::string name;
  Rgb kd{0.8f}, ks{0}, ke{0}, tf{1};
  std::optional<Rgb> ka;  // else as kd
  std::optional<float> roughness, metallic;
  float ns = 1, ni = 1, dissolve = 1;
  int64_t illum = 2;
  bool states_kd = false, states_tf = false;
  Map map_kd, map_ke, map_d, map_norm, map_rough, map_metal;
};

class Library {
 public:
  Library(const std::string& where, Beside& beside, Scene& scene, std::map<std::string, int>& index)
      : where_(where), beside_(beside), scene_(scene), index_(index) {}

  void run(std::string_view text) {
    Lines lines(text);
    std::string_view line;
    while (lines.next(line)) {
      line_number_ = lines.number();
      std::string_view rest = line;
      const std::string keyword = lower_case(next_word(rest));
      if (keyword.empty() || keyword[0] == '#') continue;
      if (keyword == "newmtl") {
        finish();
        m_.emplace().name = utf8_or_latin1(trimmed(rest));
      } else if (m_) {
        statement(keyword, rest);
      } else {
        scene_.warnings.add("MTL statements before the first newmtl were left out");
      }
    }
    finish();
  }

 private:
  void statement(const std::string& keyword, std::string_view rest) {
    if (keyword == "ka") return colour(rest, m_->ka.emplace());
    if (keyword == "kd") return m_->states_kd = true, colour(rest, m_->kd);
    if (keyword == "ks") return colour(rest, m_->ks);
    if (keyword == "ke") return colour(rest, m_->ke);
    if (keyword == "tf") return m_->states_tf = true, colour(rest, m_->tf);
    if (keyword == "ns") return number(rest, m_->ns);
    if (keyword == "ni") return number(rest, m_->ni);
    if (keyword == "d") return dissolve(rest, false);
    if (keyword == "tr") return dissolve(rest, true);
    if (keyword == "pr") return number(rest, m_->roughness.emplace());
    if (keyword == "pm") return number(rest, m_->metallic.emplace());
    if (keyword == "illum") return model(rest);
    if (keyword == "map_kd") return map(rest, m_->map_kd);
    if (keyword == "map_ke") return map(rest, m_->map_ke);
    if (keyword == "map_d") return map(rest, m_->map_d);
    if (keyword == "norm" || keyword == "map_kn") return map(rest, m_->map_norm);
    if (keyword == "map_pr") return map(rest, m_->map_rough);
    if (keyword == "map_pm") return map(rest, m_->map_metal);
    scene_.warnings.add(fmt::format("MTL statements '{}' were left out", keyword.substr(0, 24)));
  }

  /// One number or three; "spectral" and "xyz" colours are not read.
  void colour(std::string_view rest, Rgb& to) {
    std::string_view words = rest;
    const std::string_view first = next_word(words);
    if (first == "spectral" || first == "xyz")
      return scene_.warnings.add("MTL colours given as spectra or CIE XYZ were left out");
    float v[3];
    if (!parse_number(first, v[0])) return unreadable(rest);
    v[1] = v[2] = v[0];
    for (int i = 1; i < 3; ++i) {
      const std::string_view word = next_word(words);
      if (word.empty() || word[0] == '#') break;
      if (!parse_number(word, v[i])) return unreadable(rest);
    }
    const Rgb c(v[0], v[1], v[2]);
    if (!is_finite(c) || min_channel(c) < 0) return unreadable(rest);
    to = c;
  }
  void number(std::string_view rest, float& to) {
    float value = 0;
    if (!parse_number(next_word(rest), value) || !std::isfinite(value)) return unreadable(rest);
    to = value;
  }
  void dissolve(std::string_view rest, bool transparency) {
    std::string_view words = rest;
    if (next_word(words) == "-halo") rest = words;
    float value = transparency ? 1 - m_->dissolve : m_->dissolve;
    number(rest, value);
    m_->dissolve = std::clamp(transparency ? 1 - value : value, 0.0f, 1.0f);
  }
  void model(std::string_view rest) {
    if (!parse_number(next_word(rest), m_->illum)) unreadable(rest);
  }
  void unreadable(std::string_view) {
    scene_.warnings.add(fmt::format("{}: numbers of materials that could not be read keep their default", where_));
  }

  /// Options, then a file name that may hold blanks.
  void map(std::string_view rest, Map& to) {
    rest = trimmed(rest);
    while (rest.starts_with('-')) {
      const std::string option = lower_case(next_word(rest));
      float v[3] = {0, 0, 0};
      const size_t count = option == "-s" || option == "-o" || option == "-t" ? 3 : option == "-mm" ? 2 : 1;
      read_option(rest, v, count, option);
      if (option == "-s") to.scale = {v[0], v[1]};
      if (option == "-o") to.offset = {v[0], v[1]};
      if (option == "-bm") to.bump = v[0];
      rest = trimmed(rest);
    }
    to.file = utf8_or_latin1(rest);
  }
  /// Up to `count` numbers, or one word.
  void read_option(std::string_view& rest, float* v, size_t count, const std::string& option) {
    for (size_t i = 0; i < count; ++i) {
      std::string_view after = rest;
      const std::string_view word = next_word(after);
      const bool is_number = parse_number(word, v[i]) && std::isfinite(v[i]);
      if (!is_number && (i > 0 || option == "-s" || option == "-o" || option == "-t")) {
        if (option == "-s" && i > 0) v[i] = i == 1 ? v[0] : 1;
        return;
      }
      rest = after;
    }
  }

  Texture texture(const Map& map) {
    Texture use;
    if (map.file.empty()) return use;
    use.image = beside_.image(scene_, map.file);
    if (use.image < 0) return use;
    // v runs down here: v' = 1 - (1 - v) s - o
    use.scale = map.scale;
    use.offset = {map.offset.x, 1 - map.scale.y - map.offset.y};
    return use;
  }

  void finish() {
    if (!m_) return;
    if (index_.try_emplace(m_->name, int(scene_.materials.size())).second) scene_.materials.push_back(material());
    m_.reset();
  }

  /// illum 3 .. 9 are the ray traced models: 3, 5, 8 reflect; 4, 6, 7, 9 let light through as well.
  Material material() {
    Statement& s = *m_;
    if (!s.map_kd.file.empty() && (!s.states_kd || is_black(s.kd))) s.kd = Rgb(1);
    if (s.roughness || s.metallic || !s.map_rough.file.empty() || !s.map_metal.file.empty()) return physical();
    ClassicMaterial c;
    c.ka = clamped(s.ka.value_or(s.kd), 0, 1), c.kd = clamped(s.kd, 0, 1), c.ks = clamped(s.ks, 0, 1);
    c.exponent = std::clamp(s.ns, 0.0f, kLargestExponent);
    c.index = s.ni >= 1 ? s.ni : 1;
    const bool through = s.illum == 4 || s.illum == 6 || s.illum == 7 || s.illum == 9;
    if (s.illum >= 3 && s.illum <= 9) c.kr = c.ks;
    if (through) c.kt = s.states_tf ? clamped(s.tf, 0, 1) : Rgb(1 - s.dissolve);
    if (s.illum == 0 || s.illum == 1) c.ks = Rgb(0);
    Material m = material_of(c);
    if (!through) set_alpha(m);
    return common(std::move(m));
  }
  Material physical() {
    Material m;
    m.base_colour = clamped(m_->kd, 0, 1);
    m.roughness = std::clamp(m_->roughness.value_or(1), 0.0f, 1.0f);
    m.metallic = std::clamp(m_->metallic.value_or(0), 0.0f, 1.0f);
    if (m_->ni >= 1) m.ior = m_->ni > 1 ? m_->ni : 1.5f;
    set_alpha(m);
    add_metallic_roughness(m);
    return common(std::move(m));
  }
  void set_alpha(Material& m) {
    m.alpha = m_->dissolve;
    if (m.alpha < 1) m.alpha_mode = AlphaMode::blend;
  }
  /// map_d is the alpha of map_Kd, or a picture of its own.
  void add_opacity(Material& m) {
    if (m_->map_d.file.empty()) return;
    const bool own = m_->map_d.file != m_->map_kd.file;
    const Texture opacity = texture(m_->map_d);
    if (!opacity) return;
    if (own && m.base_texture && !same_place(m_->map_d, m_->map_kd))
      return scene_.warnings.add("MTL pictures of transparency (map_d) that lie unlike map_Kd were left out");
    m.alpha_mode = AlphaMode::blend;
    if (!own) return;
    const int image = beside_.with_alpha(scene_, m.base_texture.image, opacity.image);
    if (!m.base_texture) m.base_texture = opacity;
    m.base_texture.image = image;
  }
  /// A factor beside a picture multiplies it; one that is 0 or not stated would hide it.
  void add_metallic_roughness(Material& m) {
    const Texture rough = texture(m_->map_rough), metal = texture(m_->map_metal);
    if (!rough && !metal) return;
    if (rough && metal && !same_place(m_->map_rough, m_->map_metal))
      return scene_.warnings.add("MTL pictures of metal (map_Pm) that lie unlike those of roughness were left out");
    m.metallic_roughness_texture = rough ? rough : metal;
    m.metallic_roughness_texture.image = beside_.metallic_roughness(scene_, metal.image, rough.image);
    if (rough && !(m.roughness > 0)) m.roughness = 1;
    if (metal && !(m.metallic > 0)) m.metallic = 1;
  }
  static bool same_place(const Map& a, const Map& b) { return a.offset == b.offset && a.scale == b.scale; }
  Material common(Material m) {
    m.name = m_->name;
    m.emission = Radiance(m_->ke);
    m.base_texture = texture(m_->map_kd);
    add_opacity(m);
    if (!m_->map_ke.file.empty() && is_black(m.emission.v)) m.emission = Radiance(Rgb(1));
    m.emission_texture = texture(m_->map_ke);
    if (!m_->map_ke.file.empty() && !m.emission_texture) m.emission = Radiance(m_->ke);
    m.normal_texture = texture(m_->map_norm);
    m.normal_scale = m_->map_norm.bump;
    return m;
  }

  const std::string& where_;
  Beside& beside_;
  Scene& scene_;
  std::map<std::string, int>& index_;
  size_t line_number_ = 0;
  std::optional<Statement> m_;
};

}  // namespace

void read_mtl(std::string_view text, const std::string& where, Beside& beside, Scene& scene,
              std::map<std::string, int>& index) {
  Library(where, beside, scene, index).run(text);
}

}  // namespace aktina::obj
