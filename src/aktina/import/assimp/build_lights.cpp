// Lights and cameras in world space. The formats know no photometric unit: a lamp of colour 1 gives pi lx where its
// attenuation is 1, under which white paper facing it has 1 cd/m^2 - the classic models' brightness.
#include <algorithm>
#include <cmath>

#include "aktina/import/assimp/build.h"

namespace aktina::assimp {
namespace {

constexpr float kWidest = 3.1f;  // rad, of a camera's angles

Mat4 place_of(int32_t node, const Scene& scene) { return node < 0 ? Mat4(1) : scene.nodes[size_t(node)].to_world; }

/// In metres, from the file's units; without a positive factor none at all.
Attenuation attenuation(Vec3 factors, double units) {
  const auto s = float(units);
  const Attenuation a{factors.x, factors.y / s, factors.z / (s * s)};
  const bool good = a.a0 >= 0 && a.a1 >= 0 && a.a2 >= 0 && a.a0 + a.a1 + a.a2 > 0 && a.a0 + a.a1 + a.a2 < kInfinity;
  return good ? a : Attenuation{1, 0, 0};
}

SpotLight spot_of(const FileLight& from) {
  SpotLight spot;
  const auto angle = [](float v) { return v >= 0 ? std::min(v, float(kPi / 2)) : 0; };
  spot.outer_angle = std::max(angle(from.outer_angle), 1e-3f);
  spot.inner_angle = std::min(angle(from.inner_angle), spot.outer_angle);
  spot.exponent = from.exponent > 0 ? std::min(from.exponent, 1e4f) : 0;
  return spot;
}

void add_light(const FileLight& from, double units, Scene& scene) {
  const Rgb colour(from.colour.x, from.colour.y, from.colour.z);
  if (!is_finite(colour) || min_channel(colour) < 0)
    return scene.warnings.add("lights whose colour is negative or not finite were left out");
  if (from.kind == FileLight::ambient) return void(scene.ambient += colour);
  const Mat4 place = place_of(from.node, scene);
  const Point3 position = transform_point(place, from.position);
  const Vec3 direction = normalize_or(transform_vector(place, from.direction), {0, 0, -1});
  if (!is_finite(position)) return scene.warnings.add("lights whose place is not finite were left out");
  const Rgb strength = colour * float(kPi);
  PlacedLight light{from.name, DirectionalLight{direction, Irradiance(strength)}, from.node};
  if (from.kind == FileLight::point) {
    light.light = PointLight{position, Intensity(strength), attenuation(from.attenuation, units)};
  } else if (from.kind == FileLight::spot) {
    SpotLight spot = spot_of(from);
    spot.position = position, spot.direction = direction, spot.intensity = Intensity(strength);
    spot.attenuation = attenuation(from.attenuation, units);
    light.light = spot;
  }
  scene.lights.push_back(std::move(light));
}

Camera camera_of(const FileCamera& from, double units, const Scene& scene) {
  const Mat4 place = place_of(from.node, scene);
  const Point3 eye = transform_point(place, from.position);
  const Vec3 back = -normalize_or(transform_vector(place, from.forward), {0, 0, -1});
  const Vec3 up = normalize_or(transform_vector(place, from.up), {0, 1, 0});
  const Vec3 right = normalize_or(cross(up, back), Frame(back).t);
  Camera camera;
  camera.to_world = Mat4(Vec4(right, 0), Vec4(cross(back, right), 0), Vec4(back, 0), Vec4(eye, 1));
  camera.name = from.name;
  camera.aspect = from.aspect > 1e-3f && from.aspect < 1e3f ? from.aspect : 0;
  const float aspect = camera.aspect > 0 ? camera.aspect : 1;
  const float half_width = from.half_width * float(units);
  if (half_width > 0 && half_width < 1e6f) {
    camera.kind = Camera::Kind::orthographic;
    camera.half_height = half_width / aspect;
  } else {
    const float angle = from.width_angle > 1e-3f ? std::min(from.width_angle, kWidest) : 0.8f;
    camera.vertical_fov = std::min(2 * std::atan(std::tan(angle / 2) / aspect), kWidest);
  }
  const float near = from.near * float(units), far = from.far * float(units);
  if (near > 0 && near < 1e6f) camera.near = near;
  if (far > camera.near) camera.far = far;
  return camera;
}

}  // namespace

void build_lights(const Document& document, double units, Scene& scene) {
  for (const FileLight& light : document.lights) add_light(light, units, scene);
}

void build_cameras(const Document& document, double units, Scene& scene) {
  for (const FileCamera& from : document.cameras) {
    Camera camera = camera_of(from, units, scene);
    if (is_finite(camera.position()))
      scene.cameras.push_back(std::move(camera));
    else
      scene.warnings.add("cameras whose place is not finite were left out");
  }
}

}  // namespace aktina::assimp
