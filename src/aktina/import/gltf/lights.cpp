// KHR_lights_punctual: points, spots and distant lights, placed by the nodes that name them.
#include <algorithm>

#include "aktina/import/gltf/nodes.h"

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
}

}  // namespace aktina::gltf
