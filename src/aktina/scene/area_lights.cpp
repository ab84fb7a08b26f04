// Lights with an area: surfaces that emit, and back.
#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/scene/scene_lights.h"

namespace aktina {
namespace {

int add_emitter(Scene& scene, Radiance radiance, bool both_sides) {
  if (!is_finite(radiance.v) || min_channel(radiance.v) < 0)
    throw Error(Code::bad_param, "light.radiance", "should be finite and not below 0");
  Material m;
  m.base_colour = Rgb(0), m.metallic = 0, m.specular_weight = 0;
  m.emission = radiance, m.double_sided = both_sides;
  scene.materials.push_back(m);
  return int(scene.materials.size()) - 1;
}

void place(Scene& scene, const RectangleLight& light, const PlacedLight& placed) {
  const Vec3 across = cross(light.edge_u, light.edge_v);
  if (!(squared_length(across) > 0) || !is_finite(across) || !is_finite(light.corner))
    throw Error(Code::bad_param, "light.edge_u, edge_v", "have no area, or one that is not finite");
  Mesh mesh;
  mesh.name = placed.name;
  mesh.positions = {light.corner, light.corner + light.edge_u, light.corner + light.edge_u + light.edge_v,
                    light.corner + light.edge_v};
  mesh.normals.assign(4, normalize_or(across, {0, 0, 1}));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_face = {0, 0}, mesh.face_count = 1;
  mesh.material = add_emitter(scene, light.radiance, light.both_sides);
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({.mesh = int(scene.meshes.size()) - 1, .node = placed.node});
}

void place(Scene& scene, const DiscLight& light, const PlacedLight& placed) {
  const Vec3 up = normalize_or(light.direction, Vec3(0));
  if (!(light.radius > 0 && light.radius < kInfinity) || up == Vec3(0) || !is_finite(light.position))
    throw Error(Code::bad_param, "light.radius", "a disc needs a radius above 0, a direction and a place");
  const Frame frame(up);  // a disc's front is +y
  const int material = add_emitter(scene, light.radiance, light.both_sides);
  scene.primitives.emplace_back(Disc{light.radius});
  scene.instances.push_back(
      {.primitive = int(scene.primitives.size()) - 1,
       .material = material,
       .node = placed.node,
       .to_world = Mat4(Vec4(frame.b, 0), Vec4(up, 0), Vec4(frame.t, 0), Vec4(light.position, 1))});
}

/// Corners b and its neighbours a, c of triangle (a, b, c) and the fourth corner d of the other one, if the two share
/// the edge from c to a in opposite directions.
struct Corners {
  Point3 a, b, c, d;
};
std::optional<Corners> corners(const Mesh& mesh, const Mat4& to_world) {
  if (mesh.triangles.size() != 2) return {};
  const auto at = [&](int triangle, int k) { return mesh.positions[mesh.triangles[size_t(triangle)][size_t(k % 3)]]; };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (at(0, i + 2) == at(1, j) && at(0, i) == at(1, j + 2)) {
        const auto world = [&](Point3 p) { return transform_point(to_world, p); };
        return Corners{world(at(0, i)), world(at(0, i + 1)), world(at(0, i + 2)), world(at(1, j + 1))};
      }
  return {};
}

std::optional<Light> rectangle(const Mesh& mesh, const Mat4& to_world, const Material& material) {
  const auto p = corners(mesh, to_world);
  if (!p) return {};
  const float size = squared_length(p->c - p->a);
  if (!(squared_length(p->b + p->d - p->a - p->c) < 1e-10f * size)) return {};
  RectangleLight light{p->b, p->c - p->b, p->a - p->b, material.emission, material.double_sided};
  if (glm::determinant(Mat3(to_world)) < 0) std::swap(light.edge_u, light.edge_v);  // a mirror turns the front around
  if (!(squared_length(cross(light.edge_u, light.edge_v)) > 0)) return {};
  return light;
}

std::optional<Light> disc(const Disc& shape, const Mat4& m, const Material& material) {
  const Vec3 x(m[0]), y(m[1]), z(m[2]);
  const float scale = length(x);
  const bool round = std::abs(length(z) - scale) < 1e-4f * scale && std::abs(dot(x, z)) < 1e-4f * scale * scale;
  const Vec3 front = normalize_or(glm::transpose(glm::inverse(Mat3(m))) * Vec3(0, 1, 0), Vec3(0));
  if (!round || front == Vec3(0) || !(shape.radius * scale > 0)) return {};
  return DiscLight{Vec3(m[3]), front, shape.radius * scale, material.emission, material.double_sided};
}

}  // namespace

void place_light(Scene& scene, const PlacedLight& light) {
  if (const auto* rectangle = std::get_if<RectangleLight>(&light.light)) return place(scene, *rectangle, light);
  if (const auto* disc = std::get_if<DiscLight>(&light.light)) return place(scene, *disc, light);
  scene.lights.push_back(light);
}

std::optional<Light> flat_light(const Scene& scene, const Instance& instance) {
  const Material& material = scene.material_of(instance);
  if (instance.mesh >= 0) return rectangle(scene.meshes[size_t(instance.mesh)], instance.to_world, material);
  if (instance.primitive < 0) return {};
  const auto* shape = std::get_if<Disc>(&scene.primitives[size_t(instance.primitive)]);
  return shape ? disc(*shape, instance.to_world, material) : std::nullopt;
}

}  // namespace aktina
