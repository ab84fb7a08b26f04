#include "aktina/trace/surface_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr float kLeastCosine = 1e-3f;  // of wo with the shading normal

bool has_texture(const Material& m) {
  return m.base_texture || m.metallic_roughness_texture || m.emission_texture || m.transmission_texture ||
         m.specular_texture || m.specular_tint_texture;
}

void check_texture(const Scene& scene, const Texture& use, const std::string& where) {
  if (!use) return;
  if (size_t(use.image) >= scene.images.size() || use.uv_set < 0 || use.uv_set > 1)
    throw Error(Code::bad_input, where, fmt::format("a texture uses image {}, uv set {}", use.image, use.uv_set),
                fmt::format("there are {} images, and sets 0 and 1", scene.images.size()));
}

void check(const Scene& scene, const Material& m) {
  for (const Texture* use : {&m.base_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.emission_texture,
                             &m.transmission_texture, &m.specular_texture, &m.specular_tint_texture})
    check_texture(scene, *use, m.name);
}

void check(const Mesh& mesh) {
  const size_t n = mesh.positions.size();
  for (const size_t size :
       {mesh.normals.size(), mesh.tangents.size(), mesh.uv[0].size(), mesh.uv[1].size(), mesh.colours.size()})
    if (size != 0 && size != n)
      throw Error(Code::bad_input, mesh.name, fmt::format("{} values for {} vertices", size, n));
  for (const auto& t : mesh.triangles)
    for (const uint32_t vertex : t)
      if (vertex >= n)
        throw Error(Code::bad_input, mesh.name, fmt::format("a triangle names vertex {}", vertex),
                    fmt::format("there are {}", n));
}

template <class T>
T mix(const std::vector<T>& values, const std::array<uint32_t, 3>& t, const Hit& hit) {
  return values[t[0]] * (1 - hit.u - hit.v) + values[t[1]] * hit.u + values[t[2]] * hit.v;
}

float largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// n, turned towards wo as far as needed to be on its side.
Vec3 facing(Vec3 n, Vec3 wo, Vec3 geometric) {
  const float c = dot(n, wo);
  return c >= kLeastCosine ? n : normalize_or(n + wo * (2 * kLeastCosine - c), geometric);
}

}  // namespace

/// What the vertices around a hit say.
struct SurfaceTable::Local {
  Vec2 uv[2] = {Vec2(0), Vec2(0)};
  Vec4 colour{1};
};

SurfaceTable::SurfaceTable(const Scene& scene) : scene_(&scene), placed_(scene.instances.size()) {
  for (const Material& material : scene.materials) check(scene, material);
  for (const Mesh& mesh : scene.meshes) check(mesh);
  for (size_t i = 0; i < placed_.size(); ++i) {
    const Instance& instance = scene.instances[i];
    Placed& p = placed_[i];
    if (instance.mesh >= 0) p.mesh = &scene.meshes.at(size_t(instance.mesh));
    if (instance.mesh < 0 && instance.primitive >= 0)
      p.primitive.emplace(scene.primitives.at(size_t(instance.primitive)), instance.to_world);
    p.material = &scene.material_of(instance);
    p.to_world = instance.to_world;
    p.normal_to_world = glm::inverseTranspose(Mat3(instance.to_world));
    p.has_alpha = p.material->alpha_mode != AlphaMode::opaque;
    any_alpha_ = any_alpha_ || p.has_alpha;
    p.plain = !has_texture(*p.material) && (!p.mesh || p.mesh->colours.empty());
    const Vec2 nowhere[2] = {Vec2(0), Vec2(0)};
    if (p.plain) p.point = evaluate(scene, *p.material, nowhere, Vec4(1));
    if (p.plain) p.scattering.emplace(p.point.surface);
  }
}

SurfaceTable::Local SurfaceTable::locate(const Placed& placed, const Ray& ray, const Hit& hit) const {
  Local local;
  if (placed.mesh) {
    const Mesh& mesh = *placed.mesh;
    const auto& t = mesh.triangles[hit.triangle];
    for (int k = 0; k < 2; ++k)
      if (!mesh.uv[k].empty()) local.uv[k] = mix(mesh.uv[k], t, hit);
    if (!mesh.colours.empty()) local.colour = mix(mesh.colours, t, hit);
  } else if (placed.primitive) {
    local.uv[0] = local.uv[1] = placed.primitive->uv(ray.origin + hit.distance * ray.direction);
  }
  return local;
}

/// Along the ray or from the triangle's corners, whichever has the smaller rounding errors.
Point3 SurfaceTable::position(const Placed& placed, const Ray& ray, const Hit& hit) const {
  const Point3 along = ray.origin + hit.distance * ray.direction;
  if (!placed.mesh) return placed.primitive ? placed.primitive->snap(along) : along;
  const auto& t = placed.mesh->triangles[hit.triangle];
  const auto& p = placed.mesh->positions;
  const float reach = largest(ray.origin) + hit.distance * largest(ray.direction);
  const float size = std::max({largest(p[t[0]]), largest(p[t[1]]), largest(p[t[2]])});
  if (reach < size) return along;
  return transform_point(placed.to_world, mix(p, t, hit));
}

/// The normal map's normal, by the mesh's tangents or by the directions in which its texture coordinates grow.
Vec3 SurfaceTable::bumped(const Placed& placed, const Hit& hit, const Local& local, Vec3 normal) const {
  const Material& m = *placed.material;
  const Mesh& mesh = *placed.mesh;
  const auto& t = mesh.triangles[hit.triangle];
  Vec3 tangent, bitangent;
  if (!mesh.tangents.empty()) {
    const Vec4 mixed = mix(mesh.tangents, t, hit);
    tangent = transform_vector(placed.to_world, Vec3(mixed));
    tangent = normalize_or(tangent - normal * dot(normal, tangent), Frame(normal).t);
    const float mirror = glm::determinant(Mat3(placed.to_world)) < 0 ? -1.0f : 1.0f;
    bitangent = cross(normal, tangent) * (mesh.tangents[t[0]].w * mirror);
  } else {
    const auto& uv = mesh.uv[m.normal_texture.uv_set];
    if (uv.empty()) return normal;
    const Vec2 a = uv[t[1]] - uv[t[0]], b = uv[t[2]] - uv[t[0]];
    const Vec3 p = transform_vector(placed.to_world, mesh.positions[t[1]] - mesh.positions[t[0]]);
    const Vec3 q = transform_vector(placed.to_world, mesh.positions[t[2]] - mesh.positions[t[0]]);
    const float sign = a.x * b.y - a.y * b.x < 0 ? -1.0f : 1.0f;
    tangent = (p * b.y - q * a.y) * sign;
    bitangent = (p * b.x - q * a.x) * sign;  // up in the picture: v runs down
    tangent = normalize_or(tangent - normal * dot(normal, tangent), Frame(normal).t);
    const Vec3 across = cross(normal, tangent);
    bitangent = dot(across, bitangent) < 0 ? -across : across;
  }
  const Vec4 texel = look_up(scene_->images[size_t(m.normal_texture.image)], m.normal_texture,
                             local.uv[m.normal_texture.uv_set], false);
  const Vec3 n = {(2 * texel.x - 1) * m.normal_scale, (2 * texel.y - 1) * m.normal_scale, 2 * texel.z - 1};
  return normalize_or(tangent * n.x + bitangent * n.y + normal * n.z, normal);
}

void SurfaceTable::shade(const Ray& ray, const Hit& hit, bool scatters, ShadingPoint& out) const {
  const Placed& placed = placed_[hit.instance];
  out.instance = hit.instance, out.triangle = hit.triangle;
  out.material = placed.material;
  out.wo = -ray.direction;
  out.position = position(placed, ray, hit);
  const Vec3 front = normalize_or(hit.normal, out.wo);
  out.front = dot(front, out.wo) > 0;
  out.geometric = out.normal = out.front ? front : -front;
  Local local;
  const bool bumps = placed.material->normal_texture && placed.mesh;
  if (!placed.plain || bumps) local = locate(placed, ray, hit);
  if (placed.mesh && (!placed.mesh->normals.empty() || bumps)) {
    Vec3 n = front;
    if (!placed.mesh->normals.empty())
      n = normalize_or(placed.normal_to_world * mix(placed.mesh->normals, placed.mesh->triangles[hit.triangle], hit),
                       front);
    if (bumps) n = bumped(placed, hit, local, n);
    out.normal = facing(out.front ? n : -n, out.wo, out.geometric);
  }
  const MaterialPoint* point = &placed.point;
  out.scattering = placed.scattering ? &*placed.scattering : nullptr;
  if (!placed.plain) {
    point = &out.own_.emplace(evaluate(*scene_, *placed.material, local.uv, local.colour));
    if (scatters) out.scattering = &out.own_scattering_.emplace(point->surface);
  }
  out.surface = &point->surface;
  out.alpha = point->alpha;
  const bool shines = out.front || placed.material->double_sided || placed.material->unlit;
  out.emission = shines ? point->emission : Radiance();
}

MaterialPoint SurfaceTable::material_point(const Placed& placed, const Ray& ray, const Hit& hit) const {
  if (placed.plain) return placed.point;
  const Local local = locate(placed, ray, hit);
  return evaluate(*scene_, *placed.material, local.uv, local.colour);
}

float SurfaceTable::alpha(const Ray& ray, const Hit& hit) const {
  const Placed& placed = placed_[hit.instance];
  return placed.has_alpha ? material_point(placed, ray, hit).alpha : 1;
}

Rgb SurfaceTable::transmission(const Ray& ray, const Hit& hit) const {
  return material_point(placed_[hit.instance], ray, hit).surface.kt;
}

}  // namespace aktina
