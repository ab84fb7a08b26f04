#include "aktina/raster/draw_list.h"

#include <fmt/core.h>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr float kTessellation = 1e-3f;  // of primitives: error over the size of the scene

void check_count(uint64_t triangles, uint64_t vertices) {
  if (triangles <= DrawList::kMostTriangles && vertices <= 3 * DrawList::kMostTriangles) return;
  throw Error(Code::limit, "raster.triangles", fmt::format("got {} triangles, {} vertices", triangles, vertices),
              fmt::format("at most {} triangles, instances counted each", DrawList::kMostTriangles));
}

void check_indices(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices) {
  for (size_t t = 0; t < triangles.size(); ++t)
    for (const uint32_t v : triangles[t])
      if (v >= vertices)
        throw Error(Code::bad_input, fmt::format("mesh.triangles[{}]", t), fmt::format("got vertex {}", v),
                    fmt::format("the mesh has {} vertices", vertices));
}

}  // namespace

DrawList::DrawList(const Scene& scene) {
  const float tolerance = kTessellation * bounds(scene).diagonal();
  std::vector<const Mesh*> of_primitive(scene.primitives.size());
  for (const Instance& instance : scene.instances) {
    const Mesh* mesh = instance.mesh >= 0 ? &scene.meshes[size_t(instance.mesh)] : nullptr;
    if (!mesh && instance.primitive >= 0) {
      const Mesh*& tessellated = of_primitive[size_t(instance.primitive)];
      if (!tessellated)
        tessellated = &tessellated_.emplace_back(tessellate(scene.primitives[size_t(instance.primitive)], tolerance));
      mesh = tessellated;
    }
    if (mesh && !mesh->triangles.empty()) add(*mesh, instance, scene.material_of(instance));
  }
}

DrawList::DrawList(std::span<const Point3> positions, std::span<const std::array<uint32_t, 3>> triangles) {
  check_count(triangles.size(), positions.size());
  check_indices(triangles, positions.size());
  vertex_count_ = uint32_t(positions.size()), triangle_count_ = uint32_t(triangles.size());
  for (auto& axis : position_) axis.resize(vertex_count_);
  for (auto& corner : index_) corner.resize(triangle_count_);
  for (uint32_t v = 0; v < vertex_count_; ++v) set_position(v, positions[v]);
  for (uint32_t t = 0; t < triangle_count_; ++t)
    for (size_t k = 0; k < 3; ++k) index_[k][t] = triangles[t][k];
  parts_.push_back({nullptr, nullptr, 0, vertex_count_, 0, triangle_count_, false});
}

void DrawList::set_position(uint32_t vertex, Point3 p) {
  for (int axis = 0; axis < 3; ++axis) position_[axis][vertex] = p[axis];
}

void DrawList::set_normal(uint32_t vertex, Vec3 n) {
  for (int axis = 0; axis < 3; ++axis) normal_[axis][vertex] = n[axis];
}

void DrawList::add(const Mesh& mesh, const Instance& instance, const Material& material) {
  const bool flat = mesh.normals.size() != mesh.positions.size();
  const uint64_t vertices = flat ? 3 * mesh.triangles.size() : mesh.positions.size();
  const uint64_t first = padded(vertex_count_);
  check_count(triangle_count_ + mesh.triangles.size(), first + vertices);
  check_indices(mesh.triangles, mesh.positions.size());
  const DrawPart part{
      &mesh, &material, uint32_t(first), uint32_t(vertices), triangle_count_, uint32_t(mesh.triangles.size()), flat};
  vertex_count_ = part.first_vertex + part.vertex_count;
  triangle_count_ += part.triangle_count;
  for (auto& axis : position_) axis.resize(vertex_count_);
  for (auto& axis : normal_) axis.resize(vertex_count_);
  for (auto& corner : index_) corner.resize(triangle_count_);
  for (uint32_t v = 0; v < part.vertex_count; ++v)
    set_position(part.first_vertex + v,
                 transform_point(instance.to_world, mesh.positions[part.mesh_vertex(part.first_vertex + v)]));
  add_corners(mesh, part, glm::determinant(Mat3(instance.to_world)) < 0);
  add_normals(mesh, part, instance.to_world);
  parts_.push_back(part);
}

void DrawList::add_corners(const Mesh& mesh, const DrawPart& part, bool mirrored) {
  for (uint32_t t = 0; t < part.triangle_count; ++t)
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t source = mirrored ? (3 - k) % 3 : k;
      index_[k][part.first_triangle + t] = part.first_vertex + (part.flat ? 3 * t + source : mesh.triangles[t][source]);
    }
}

void DrawList::add_normals(const Mesh& mesh, const DrawPart& part, const Mat4& to_world) {
  const Mat3 normal_matrix = glm::transpose(glm::inverse(Mat3(to_world)));
  if (!part.flat)
    for (uint32_t v = 0; v < part.vertex_count; ++v)
      set_normal(part.first_vertex + v, normalize_or(normal_matrix * mesh.normals[v], Vec3(0)));
  for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t) {
    const uint32_t ix[3] = {index_[0][t], index_[1][t], index_[2][t]};
    const Point3 a = position_of(ix[0]);
    for (const uint32_t v : ix)
      if (normal_of(v) == Vec3(0))
        set_normal(v, normalize_or(cross(position_of(ix[1]) - a, position_of(ix[2]) - a), {0, 0, 1}));
  }
}

}  // namespace aktina
