// KHR_lights_punctual and EXT_lights_ies: points, spots, distant lights and measured luminaires, placed by the nodes
// that name them.
#include <algorithm>

#include "aktina/import/gltf/nodes.h"
#include "aktina/import/luminaire/luminaire.h"

namespace aktina::gltf {
namespace {

Light read_spot(Document& document, const Value& place, const Rgb colour, const Mat4& to_world) {
  SpotLight spot;
  spot.position = Vec3(to_world[3]), spot.direction = -Vec3(rigid(to_world)[2]);
  spot.intensity = Intensity(colour);
  spot.inner_angle = place["spot"]["innerConeAngle"].real(0);
  spot.outer_angle = place["spot"]["outerConeAngle"].real(float(kPi / 4));
  const bool good =
      spot.inner_angle >= 0 && spot.outer_angle > spot.inner_angle && spot.outer_angle <= float(kPi / 2) + 1e-4f;
  if (!good) document.warnings.add("spot lights with cone angles out of order or range were corrected");
  spot.outer_angle = std::clamp(spot.outer_angle, 1e-3f, float(kPi / 2));
  spot.inner_angle = std::clamp(spot.inner_angle, 0.0f, spot.outer_angle);
  return spot;
}

std::optional<Light> read_light(Document& document, const Value& place, const Mat4& to_world) {
  const Rgb colour = place["color"].rgb(Rgb(1)) * place["intensity"].real(1);
  if (!is_finite(colour) || min_channel(colour) < 0) place["intensity"].fail("should be finite and not below 0");
  const std::string_view type = place["type"].text_view();
  if (type == "point") return PointLight{Vec3(to_world[3]), Intensity(colour)};
  if (type == "spot") return read_spot(document, place, colour, to_world);
  if (type == "directional") return DirectionalLight{-Vec3(rigid(to_world)[2]), Irradiance(colour)};
  document.warnings.add("lights that are neither point, spot nor directional were left out");
  return std::nullopt;
}

/// EXT_lights_ies: photometry from an IES file beside or within the document.
std::optional<Light> read_luminaire(Document& document, const Value& use, const Value& place, const Mat4& to_world) {
  std::vector<uint8_t> bytes;
  if (place["uri"]) {
    bytes = fetch(document, place["uri"]);
  } else {
    const int view = place["bufferView"].index(document.list("bufferViews").size());
    if (view < 0) place.fail("has neither a uri nor a bufferView");
    const auto data = document.view(size_t(view));
    bytes.assign(data.begin(), data.end());
  }
  const Mat4 turn = rigid(to_world);
  LuminaireLight light;
  light.position = Vec3(to_world[3]), light.direction = -Vec3(turn[2]), light.c0 = Vec3(turn[0]);
  light.colour = use["color"].rgb(Rgb(1)) * use["multiplier"].real(1);
  if (!is_finite(light.colour) || min_channel(light.colour) < 0)
    use["multiplier"].fail("should be finite, not below 0");
  light.table = read_ies(bytes, document.folder, place.place()).table;
  return light;
}

}  // namespace

void read_lights(Document& document, const Hierarchy& hierarchy, Scene& scene) {
  const Value nodes = document.list("nodes");
  const Value lights = document.root().extension("KHR_lights_punctual")["lights"];
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const int index = nodes[size_t(hierarchy.source[i])].extension("KHR_lights_punctual")["light"].index(lights.size());
    if (index < 0) continue;
    const Value place = lights[size_t(index)];
    const std::string name = place["name"].text(scene.nodes[i].name);
    if (const auto light = read_light(document, place, scene.nodes[i].to_world))
      scene.lights.push_back({name, *light, int(i)});
  }
  const Value luminaires = document.root().extension("EXT_lights_ies")["lights"];
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const Value use = nodes[size_t(hierarchy.source[i])].extension("EXT_lights_ies");
    const int index = use["light"].index(luminaires.size());
    if (index < 0) continue;
    const Value place = luminaires[size_t(index)];
    if (const auto light = read_luminaire(document, use, place, scene.nodes[i].to_world))
      scene.lights.push_back({place["name"].text(scene.nodes[i].name), *light, int(i)});
  }
}

}  // namespace aktina::gltf
