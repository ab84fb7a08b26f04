// KHR_lights_punctual: points, spots and distant lights, placed by the nodes that name them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/import/gltf/nodes.h"
#include "aktina/scene/scene_lights.h"

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

/// extras.aktina.light of a node: lamps that KHR_lights_punctual cannot say (docs/extras.aktina.schema.json). They
/// shine along -z of the node, as all lights of glTF do.
class ExtraLight {
 public:
  ExtraLight(const Value& place, const Mat4& to_world) : place_(place), to_world_(to_world), placed_(rigid(to_world)) {}

  Light read() const {
    const std::string_view type = place_["type"].text_view();
    if (type == "point") return PointLight{position(), intensity(), attenuation()};
    if (type == "spot") return spot();
    if (type == "warn") return warn();
    if (type == "rectangle") return rectangle();
    if (type == "disc") return disc();
    place_["type"].fail("is not one of point, spot, warn, rectangle, disc");
  }

 private:
  Point3 position() const { return Vec3(placed_[3]); }
  Vec3 direction() const { return -Vec3(placed_[2]); }
  float number(const char* name, float otherwise, float least, float most) const {
    const float value = place_[name].real(otherwise);
    if (!(value >= least && value <= most)) place_[name].fail(fmt::format("should be from {} to {}", least, most));
    return value;
  }
  Rgb colour(const char* name) const {
    const Rgb value = place_[name].rgb(Rgb(1));
    if (!is_finite(value) || min_channel(value) < 0) place_[name].fail("should be finite and not below 0");
    return value;
  }
  Intensity intensity() const { return Intensity(colour("intensity")); }
  Attenuation attenuation() const {
    float a[3] = {0, 0, 1};
    Attenuation out;
    if (place_["attenuation"].numbers(a)) {
      if (!(a[0] >= 0 && a[1] >= 0 && a[2] >= 0 && a[0] + a[1] + a[2] > 0 && a[0] + a[1] + a[2] < kInfinity))
        place_["attenuation"].fail("should be three numbers not below 0, not all of them 0");
      out.a0 = a[0], out.a1 = a[1], out.a2 = a[2];
    }
    out.clamp = place_["clamp"].flag(false);
    return out;
  }
  Light spot() const {
    SpotLight light{.position = position(), .direction = direction(), .intensity = intensity()};
    light.outer_angle = number("outer_angle", float(kPi / 4), 0, float(kPi));
    light.inner_angle = number("inner_angle", light.outer_angle, 0, float(kPi));
    light.exponent = number("exponent", 0, 0, 1e6f);
    light.attenuation = attenuation();
    return light;
  }
  Light warn() const {
    WarnLight light{.position = position(), .direction = direction(), .intensity = intensity()};
    light.exponent = number("exponent", 1, 0, 1e6f);
    light.cone_angle = number("cone_angle", float(kPi), 0, float(kPi));
    const auto flap = [&](const char* name, Point3& to) {
      float p[3];
      if (place_[name].numbers(p)) to = {p[0], p[1], p[2]};
      if (!is_finite(to)) place_[name].fail("should be three finite numbers");
    };
    flap("flap_low", light.flap_low), flap("flap_high", light.flap_high);
    light.attenuation = attenuation();
    return light;
  }
  Light rectangle() const {
    const float width = number("width", 1, 1e-6f, 1e6f), height = number("height", 1, 1e-6f, 1e6f);
    RectangleLight light;
    light.corner = transform_point(to_world_, {-width / 2, -height / 2, 0});
    light.edge_u = transform_vector(to_world_, {0, height, 0});  // u x v is -z
    light.edge_v = transform_vector(to_world_, {width, 0, 0});
    if (glm::determinant(Mat3(to_world_)) < 0) std::swap(light.edge_u, light.edge_v);
    light.radiance = Radiance(colour("radiance")), light.both_sides = place_["both_sides"].flag(false);
    if (!(squared_length(cross(light.edge_u, light.edge_v)) > 0)) place_.fail("is scaled to nothing by its node");
    return light;
  }
  Light disc() const {
    const float scale = std::cbrt(std::abs(glm::determinant(Mat3(to_world_))));
    DiscLight light{.position = position(), .direction = direction()};
    light.radius = number("radius", 0.5f, 1e-6f, 1e6f) * scale;
    light.radiance = Radiance(colour("radiance")), light.both_sides = place_["both_sides"].flag(false);
    if (!(light.radius > 0 && light.radius < kInfinity)) place_.fail("is scaled to nothing by its node");
    return light;
  }

  const Value& place_;
  const Mat4& to_world_;
  Mat4 placed_;
};

}  // namespace

void read_lights(Document& document, const Hierarchy& hierarchy, Scene& scene) {
  const Value nodes = document.list("nodes");
  const Value lights = document.root().extension("KHR_lights_punctual")["lights"];
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    if (const Value extra = nodes[size_t(hierarchy.source[i])].aktina_extras()["light"]) {
      document.allowance.take(sizeof(Mesh) + sizeof(Material), extra);
      place_light(scene, {scene.nodes[i].name, ExtraLight(extra, scene.nodes[i].to_world).read(), int(i)});
    }
    const int index = nodes[size_t(hierarchy.source[i])].extension("KHR_lights_punctual")["light"].index(lights.size());
    if (index < 0) continue;
    const Value place = lights[size_t(index)];
    const std::string name = place["name"].text(scene.nodes[i].name);
    if (const auto light = read_light(document, place, scene.nodes[i].to_world))
      scene.lights.push_back({name, *light, int(i)});
  }
}

}  // namespace aktina::gltf
