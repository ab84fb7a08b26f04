#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/markup.h"
#include "aktina/image/codec.h"
#include "aktina/image/metric.h"
#include "aktina/render/study/html.h"
#include "aktina/render/study/quality.h"

namespace aktina {
namespace {

constexpr float kBrightest = 0.25f;  // difference that the map shows brightest, of white

std::string base64(std::span<const uint8_t> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) group = group << 8 | (k < left ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// @param image  linear, 1 is white
std::string data_uri(const Image& image) {
  LayeredImage picture;
  picture.layers.push_back({"", image});
  ImageWriteOptions options;
  options.tone_mapping.exposure = 1;
  return "data:image/png;base64," + base64(png_codec.encode(picture, options));
}

Image difference_map(const Image& a, const Image& b) {
  Image map(a.width, a.height, 1);
  for (size_t i = 0; i < map.pixels.size(); ++i) {
    const float* p = &a.pixels[3 * i];
    const float* q = &b.pixels[3 * i];
    const float largest = std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])});
    map.pixels[i] = std::min(largest / kBrightest, 1.0f);
  }
  return false_colour(map);
}

Image clipped(Image image) {
  for (float& value : image.pixels) value = std::clamp(value, 0.0f, 1.0f);
  return image;
}

std::string image_tag(const Image& image, const char* kind, const std::string& name) {
  return fmt::format("<img width='{}' height='{}' class='{}' alt='{} of {}' src='{}'>", image.width, image.height, kind,
                     kind, escaped(name), data_uri(image));
}

std::string figure(const std::string& name, const std::string& images, const std::string& caption) {
  return fmt::format("<figure data-name='{0}'>{1}<figcaption><b>{0}</b> {2}</figcaption></figure>", escaped(name),
                     images, caption);
}

std::string slider(const Study& study, size_t number) {
  std::string names = fmt::format("<option>{}</option>", "reference");
  for (const MethodStudy& m : study.methods)
    if (!m.picture.empty()) names += fmt::format("<option>{}</option>", escaped(m.choice));
  return fmt::format(
      "<div class='compare' id='compare{0}'><p class='controls'><label>left <select class='left'>{1}</select></label> "
      "<label>right <select class='right'>{1}</select></label> "
      "<label>show <select class='kind'><option value='picture'>pictures</option><option value='difference'>differences"
      "</option><option value='flip'>FLIP maps</option></select></label></p>"
      "<div class='stage'><img class='under' alt=''><img class='over' alt=''><div class='bar'></div></div>"
      "<input type='range' min='0' max='100' value='50' aria-label='where the pictures meet'></div>",
      number, names);
}

}  // namespace

std::string html_pictures(const Study& study, size_t number) {
  const Image right = clipped(exposed(study.reference_picture, study.exposure));
  std::string figures = figure("reference", image_tag(right, "picture", "the reference"), escaped(study.reference));
  for (const MethodStudy& m : study.methods) {
    if (m.picture.empty()) continue;
    const Image shown_picture = clipped(exposed(m.picture, study.exposure));
    figures += figure(m.choice,
                      image_tag(shown_picture, "picture", m.choice) +
                          image_tag(difference_map(shown_picture, right), "difference", m.choice) +
                          image_tag(false_colour(flip_map(shown_picture, right)), "flip", m.choice),
                      fmt::format("RMSE {}, FLIP {}", shown(m.quality.rmse), shown(m.quality.flip)));
  }
  return fmt::format(
      "<h3>Pictures</h3>{}<p>Below, each method with its difference from the reference (black: none; brightest: a "
      "quarter "
      "of white or more) and its FLIP map (black: none; brightest: 1).</p><div class='gallery'>{}</div>",
      slider(study, number), figures);
}

}  // namespace aktina
