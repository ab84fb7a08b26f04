#include "aktina/image/exr_layers.h"

#include <algorithm>

namespace aktina {
namespace {

std::string_view prefix(std::string_view channel) {
  const size_t dot = channel.rfind('.');
  return dot == channel.npos ? std::string_view() : channel.substr(0, dot);
}
std::string full_name(std::string_view layer, std::string_view channel) {
  return layer.empty() ? std::string(channel) : std::string(layer) + "." + std::string(channel);
}

struct Pattern {
  std::vector<std::string_view> needed;
  bool alpha, luminance_chroma, colour;
};

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all = {
      {{"R", "G", "B"}, true, false, true},   {{"r", "g", "b"}, true, false, true},
      {{"Y", "RY", "BY"}, true, true, false}, {{"X", "Y", "Z"}, false, false, false},
      {{"x", "y", "z"}, false, false, false}, {{"Y"}, true, false, false}};
  return all;
}

/// Takes the channels of one layer that form a picture out of `names`.
void take_picture(const std::string& layer, std::vector<std::string>& names, std::vector<ExrLayer>& layers) {
  const auto has = [&](std::string_view channel) {
    return std::find(names.begin(), names.end(), full_name(layer, channel)) != names.end();
  };
  for (const Pattern& pattern : patterns()) {
    if (!std::all_of(pattern.needed.begin(), pattern.needed.end(), has)) continue;
    ExrLayer found{layer, {}, pattern.luminance_chroma, pattern.colour};
    for (const std::string_view channel : pattern.needed) found.channels.push_back(full_name(layer, channel));
    const std::string_view alpha = pattern.needed[0] == "r" ? "a" : "A";
    if (pattern.alpha && has(alpha)) found.channels.push_back(full_name(layer, alpha));
    std::erase_if(names, [&](const std::string& name) {
      return std::find(found.channels.begin(), found.channels.end(), name) != found.channels.end();
    });
    layers.push_back(std::move(found));
    return;
  }
}

}  // namespace

std::vector<ExrLayer> group_exr_channels(const std::vector<std::string>& channels) {
  std::vector<std::string> rest = channels;
  std::vector<std::string> names = {""};
  for (const std::string& channel : channels)
    if (std::find(names.begin(), names.end(), prefix(channel)) == names.end()) names.emplace_back(prefix(channel));

  std::vector<ExrLayer> layers;
  for (const std::string& name : names) take_picture(name, rest, layers);
  for (const std::string& channel : rest) layers.push_back({channel, {channel}});
  auto picture = std::find_if(layers.begin(), layers.end(), [](const ExrLayer& l) { return l.name.empty(); });
  if (picture == layers.end()) picture = std::find_if(layers.begin(), layers.end(), [](auto& l) { return l.colour; });
  if (picture != layers.end()) std::rotate(layers.begin(), picture, picture + 1);
  return layers;
}

std::vector<std::string> exr_channel_names(const std::string& layer, int channels) {
  if (layer == "Z" && channels == 1) return {"Z"};
  const bool vector = channels == 3 && (layer == "N" || layer == "P");
  const std::string_view letters = channels <= 2 ? "YA" : vector ? "XYZ" : "RGBA";
  std::vector<std::string> names;
  for (size_t c = 0; c < size_t(channels); ++c) names.push_back(full_name(layer, letters.substr(c, 1)));
  return names;
}

}  // namespace aktina
