#include "aktina/scene/scene.h"

#include <algorithm>

namespace aktina {
namespace {

/// Smallest box about a transformed box. J. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems, 1990.
Bounds transformed(const Mat4& m, const Bounds& b) {
  Bounds out;
  if (b.empty()) return out;
  out.low = out.high = Vec3(m[3]);
  for (int column = 0; column < 3; ++column) {
    const Vec3 low = Vec3(m[column]) * b.low[column], high = Vec3(m[column]) * b.high[column];
    out.low += glm::min(low, high), out.high += glm::max(low, high);
  }
  return out;
}

template <class T>
void add(Hash64& hash, const std::vector<T>& values) {
  hash.add_values(std::span<const T>(values));
}

void add(Hash64& hash, const Mesh& mesh) {
  add(hash, mesh.positions), add(hash, mesh.normals), add(hash, mesh.tangents);
  add(hash, mesh.uv[0]), add(hash, mesh.uv[1]), add(hash, mesh.colours);
  add(hash, mesh.triangles), add(hash, mesh.triangle_face);
  hash.add_value(mesh.material);
}

void add(Hash64& hash, const Texture& t) {
  const float numbers[] = {float(t.image), float(t.uv_set), t.offset.x, t.offset.y, t.scale.x, t.scale.y, t.rotation};
  hash.add_value(numbers);
  const uint8_t choices[] = {uint8_t(t.wrap_u), uint8_t(t.wrap_v), uint8_t(t.filter)};
  hash.add_value(choices);
}

void add(Hash64& hash, const ClassicMaterial& c) { hash.add_value(c); }

void add(Hash64& hash, const Material& m) {
  const float numbers[] = {m.alpha,        m.metallic,        m.roughness, m.normal_scale, m.occlusion_strength,
                           m.alpha_cutoff, m.specular_weight, m.ior,       m.transmission};
  hash.add_value(numbers);
  for (const Rgb colour : {m.base_colour, m.emission.v, m.specular_tint}) hash.add_value(colour);
  for (const Texture* t : {&m.base_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.occlusion_texture,
                           &m.emission_texture, &m.transmission_texture, &m.specular_texture, &m.specular_tint_texture})
    add(hash, *t);
  const uint8_t choices[] = {uint8_t(m.alpha_mode), m.double_sided, m.unlit, m.classic.has_value()};
  hash.add_value(choices);
  if (m.classic) add(hash, *m.classic);
}

void add(Hash64& hash, const TextureImage& image) {
  if (!image.encoded.empty()) return add(hash, image.encoded);
  std::visit([&](const auto& p) { hash.add_value(p.width), hash.add_value(p.height), add(hash, p.pixels); },
             image.pixels);
}

void add(Hash64& hash, const Attenuation& a) {
  const float numbers[] = {a.a0, a.a1, a.a2, float(a.clamp)};
  hash.add_value(numbers);
}
void add(Hash64& hash, const PointLight& l) {
  hash.add_value(l.position), hash.add_value(l.intensity.v), add(hash, l.attenuation);
}
void add(Hash64& hash, const SpotLight& l) {
  hash.add_value(l.position), hash.add_value(l.direction), hash.add_value(l.intensity.v), add(hash, l.attenuation);
  const float cone[] = {l.inner_angle, l.outer_angle, l.exponent};
  hash.add_value(cone);
}
void add(Hash64& hash, const DirectionalLight& l) { hash.add_value(l.direction), hash.add_value(l.e_perp.v); }
void add(Hash64& hash, const LuminaireLight& l) {
  const Vec3 place[] = {l.position, l.direction, l.c0};
  hash.add_value(place), hash.add_value(l.colour);
  if (l.table) add(hash, l.table->c), add(hash, l.table->gamma), add(hash, l.table->candela);
}

void add(Hash64& hash, const WarnLight& l) {
  const Vec3 place[] = {l.position, l.direction, l.flap_low, l.flap_high};
  const float cone[] = {l.exponent, l.cone_angle};
  hash.add_value(place), hash.add_value(cone), hash.add_value(l.intensity.v), add(hash, l.attenuation);
}
void add(Hash64& hash, const RectangleLight& l) {
  const Vec3 place[] = {l.corner, l.edge_u, l.edge_v};
  hash.add_value(place), hash.add_value(l.radiance.v), hash.add_value(l.both_sides);
}
void add(Hash64& hash, const DiscLight& l) {
  const Vec3 place[] = {l.position, l.direction};
  hash.add_value(place), hash.add_value(l.radius), hash.add_value(l.radiance.v), hash.add_value(l.both_sides);
}

void add(Hash64& hash, const Camera& c) {
  const float numbers[] = {float(c.kind), c.vertical_fov, c.half_height, c.aspect, c.near, c.far};
  hash.add_value(c.to_world), hash.add_value(numbers);
}

void add(Hash64& hash, const EnvironmentLight& e) {
  hash.add_value(e.radiance.width), add(hash, e.radiance.pixels);
  hash.add_value(e.colour.v), hash.add_value(e.rotation);
}

Material matt() {
  Material m;
  m.base_colour = Rgb(0.8f);
  m.metallic = 0;
  m.specular_weight = 0;
  return m;
}

}  // namespace

const Material& Scene::material_of(const Instance& instance) const {
  static const Material kDefault = matt();
  const int own = instance.mesh >= 0 ? meshes[size_t(instance.mesh)].material : -1;
  const int index = instance.material >= 0 ? instance.material : own;
  return index >= 0 ? materials[size_t(index)] : kDefault;
}

Bounds bounds(const Scene& scene) {
  std::vector<Bounds> meshes;
  for (const Mesh& mesh : scene.meshes) meshes.push_back(bounds(mesh));
  Bounds all;
  for (const Instance& instance : scene.instances) {
    if (instance.mesh >= 0) all.add(transformed(instance.to_world, meshes[size_t(instance.mesh)]));
    if (instance.primitive >= 0)
      all.add(transformed(instance.to_world, bounds(scene.primitives[size_t(instance.primitive)])));
  }
  return all;
}

uint64_t triangle_count(const Scene& scene) {
  uint64_t count = 0;
  for (const Instance& instance : scene.instances)
    if (instance.mesh >= 0) count += scene.meshes[size_t(instance.mesh)].triangles.size();
  return count;
}

Hash64 hash(const Scene& scene) {
  Hash64 hash;
  const size_t counts[] = {scene.meshes.size(),    scene.primitives.size(), scene.materials.size(), scene.images.size(),
                           scene.instances.size(), scene.lights.size(),     scene.cameras.size()};
  hash.add_value(counts);
  for (const Mesh& mesh : scene.meshes) add(hash, mesh);
  for (const Primitive& primitive : scene.primitives) {
    hash.add_value(primitive.index());
    std::visit([&](const auto& shape) { hash.add_value(shape); }, primitive);
  }
  for (const Material& material : scene.materials) add(hash, material);
  for (const TextureImage& image : scene.images) add(hash, image);
  for (const Instance& i : scene.instances) {
    const int indices[] = {i.mesh, i.primitive, i.material};
    hash.add_value(indices), hash.add_value(i.to_world);
  }
  for (const PlacedLight& light : scene.lights) {
    hash.add_value(light.light.index());
    std::visit([&](const auto& l) { add(hash, l); }, light.light);
  }
  for (const Camera& camera : scene.cameras) add(hash, camera);
  add(hash, scene.environment);
  hash.add_value(scene.ambient), hash.add_value(scene.background.v);
  return hash;
}

}  // namespace aktina
