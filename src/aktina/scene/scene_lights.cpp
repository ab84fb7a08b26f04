#include "aktina/scene/scene_lights.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr size_t kMostEmitters = 8;  // lamps that stand for emissive surfaces, at most

/// A piece of an emissive surface: area-weighted sums of what a lamp in its place needs.
struct Emitter {
  double area = 0;
  Vec3d centre{0}, normal{0};  // times the area
  Rgb radiance;
  bool both_sides = false;
  int instance = -1;
  double power() const { return area * double(luminance(radiance)); }
};

Emitter emitter_of(const Scene& scene, size_t index, const Material& material) {
  const Instance& instance = scene.instances[index];
  Emitter e;
  e.radiance = material.emission.v;
  e.both_sides = material.double_sided;
  e.instance = int(index);
  if (instance.mesh < 0 && instance.primitive < 0) return e;
  Mesh tessellated;
  if (instance.mesh < 0) {
    const Primitive& shape = scene.primitives[size_t(instance.primitive)];
    tessellated = tessellate(shape, 1e-2f * bounds(shape).diagonal());
  }
  const Mesh& mesh = instance.mesh < 0 ? tessellated : scene.meshes[size_t(instance.mesh)];
  for (const auto& t : mesh.triangles) {
    Vec3d p[3];
    for (size_t v = 0; v < 3; ++v) p[v] = transform_point(instance.to_world, mesh.positions[t[v]]);
    const Vec3d twice = cross(p[1] - p[0], p[2] - p[0]);
    const double area = length(twice) / 2;
    if (!(area > 0)) continue;
    e.area += area;
    e.centre += (p[0] + p[1] + p[2]) * (area / 3);
    e.normal += twice * 0.5;
  }
  return e;
}

/// A surface that looks all around (a sphere, a box) shines as a point does, a flat one as Lambert's cosine has it. The
/// area softens the inverse square law close by, as it does for a disc: E = I / (d^2 + A / pi).
void add_lamps(const Emitter& e, std::vector<Light>& lights) {
  const Vec3 centre = e.centre / e.area;
  Attenuation soft;
  soft.a0 = float(e.area / kPi);
  const double one_way = length(e.normal) / e.area;  // 1: flat; 0: closed
  if (one_way < 0.5) {
    lights.push_back(PointLight{centre, Intensity(e.radiance * float(e.area / 4)), soft});
    return;
  }
  SpotLight spot{.position = centre, .direction = normalize(Vec3(e.normal)), .attenuation = soft};
  spot.intensity = Intensity(e.radiance * float(length(e.normal)));
  spot.inner_angle = spot.outer_angle = float(kPi / 2);
  spot.exponent = 1;
  lights.push_back(spot);
  if (!e.both_sides) return;
  spot.direction = -spot.direction;
  lights.push_back(spot);
}

/// Mean radiance over the sphere of directions.
Rgb mean_radiance(const EnvironmentLight& sky) {
  if (!sky.shines()) return {};
  constexpr int kRows = 32, kColumns = 64;
  Vec3d sum(0);
  double weight = 0;
  for (int row = 0; row < kRows; ++row) {
    const double theta = kPi * (row + 0.5) / kRows, sine = std::sin(theta);
    for (int column = 0; column < kColumns; ++column) {
      const double phi = 2 * kPi * (column + 0.5) / kColumns;
      const Rgb l = radiance(sky, Vec3(sine * std::cos(phi), std::cos(theta), sine * std::sin(phi))).v;
      sum += Vec3d(l.r, l.g, l.b) * sine;
      weight += sine;
    }
  }
  return {float(sum.x / weight), float(sum.y / weight), float(sum.z / weight)};
}

}  // namespace

SceneLights scene_lights(const Scene& scene) {
  SceneLights out;
  for (const PlacedLight& placed : scene.lights) out.lights.push_back(placed.light);
  std::vector<Emitter> emitters;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Material& material = scene.material_of(scene.instances[i]);
    if (!material.emits() || material.unlit) continue;
    const Emitter e = emitter_of(scene, i, material);
    if (e.power() > 0) emitters.push_back(e);
  }
  std::stable_sort(emitters.begin(), emitters.end(),
                   [](const Emitter& a, const Emitter& b) { return a.power() > b.power(); });
  out.instance.assign(out.lights.size(), -1);
  for (size_t i = 0; i < std::min(emitters.size(), kMostEmitters); ++i) {
    const auto flat = flat_light(scene, scene.instances[size_t(emitters[i].instance)]);
    if (flat)
      out.lights.push_back(*flat);
    else
      add_lamps(emitters[i], out.lights);
    out.instance.resize(out.lights.size(), emitters[i].instance);
  }
  out.ambient = scene.ambient + mean_radiance(scene.environment);
  return out;
}

}  // namespace aktina
