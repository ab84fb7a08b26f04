#include "aktina/import/mesh_tools.h"

#include <fmt/core.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/import/repair.h"

namespace aktina {
namespace {

template <class T>
void append(std::vector<T>& to, size_t before, const std::vector<T>& more, size_t added, T filling) {
  if (to.empty() && more.empty()) return;
  to.resize(before, filling);
  to.insert(to.end(), more.begin(), more.end());
  to.resize(before + added, filling);
}

/// Every triangle gets its face.
void spell_out_faces(Mesh& mesh) {
  if (!mesh.triangle_face.empty() || mesh.triangles.empty()) return;
  mesh.face_count = uint32_t(mesh.triangles.size());
  for (uint32_t i = 0; i < mesh.face_count; ++i) mesh.triangle_face.push_back(i);
}

}  // namespace

void append(Mesh& mesh, const Mesh& more) {
  const size_t before = mesh.positions.size(), added = more.positions.size();
  append(mesh.positions, before, more.positions, added, Point3(0));
  append(mesh.normals, before, more.normals, added, Vec3(0));
  for (int set = 0; set < 2; ++set) append(mesh.uv[set], before, more.uv[set], added, Vec2(0));
  append(mesh.colours, before, more.colours, added, Vec4(1));
  if (!mesh.triangle_face.empty() || !more.triangle_face.empty()) {
    Mesh other;
    other.triangles = more.triangles, other.triangle_face = more.triangle_face, other.face_count = more.face_count;
    spell_out_faces(mesh), spell_out_faces(other);
    for (const uint32_t face : other.triangle_face) mesh.triangle_face.push_back(mesh.face_count + face);
    mesh.face_count += other.face_count;
  }
  for (const auto& t : more.triangles)
    mesh.triangles.push_back({uint32_t(t[0] + before), uint32_t(t[1] + before), uint32_t(t[2] + before)});
}

void add_mesh(Scene& scene, Mesh mesh, const ImportOptions& options, int node) {
  repair(mesh, scene.warnings);
  if (mesh.triangles.empty()) return;
  generate_normals(mesh, options.crease);
  const int material = mesh.material;
  if (material >= 0 && scene.materials[size_t(material)].normal_texture)
    generate_tangents(mesh, scene.materials[size_t(material)].normal_texture.uv_set);
  Instance instance;
  instance.mesh = int(scene.meshes.size()), instance.node = node;
  if (node >= 0) instance.to_world = scene.nodes[size_t(node)].to_world;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
}

void finish_scene(Scene& scene, const ImportOptions& options, const std::string& instead) {
  if (scene.instances.empty())
    throw Error(Code::bad_input, scene.source, "holds no surface to draw",
                instead.empty() ? "no polygons were left" : "it has " + instead);
  if (options.metres_per_unit > 0) {
    scene.metres_per_unit = options.metres_per_unit;
    const auto s = float(options.metres_per_unit);
    const Mat4 scale(s, 0, 0, 0, 0, s, 0, 0, 0, 0, s, 0, 0, 0, 0, 1);
    for (Node& node : scene.nodes) {
      if (node.parent < 0) node.local = scale * node.local;
      node.to_world = scale * node.to_world;
    }
    for (Instance& instance : scene.instances) instance.to_world = scale * instance.to_world;
  }
  if (options.default_camera) add_default_camera(scene);
  if (options.default_light) add_default_light(scene);
}

}  // namespace aktina
