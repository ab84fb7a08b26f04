#include "aktina/export/gltf_mesh.h"

#include <algorithm>

namespace aktina::gltf_export {
namespace {

int colours(GltfFile& file, const std::vector<Vec4>& source) {
  std::vector<Vec4> clamped = source;
  bool opaque = true;
  for (Vec4& c : clamped) {
    c = glm::clamp(c, Vec4(0), Vec4(1));
    opaque = opaque && c.w == 1;
  }
  return file.attribute(&clamped[0].x, clamped.size(), opaque ? 3 : 4, 4);
}

}  // namespace

Json primitive_json(GltfFile& file, const Mesh& mesh) {
  const size_t n = mesh.positions.size();
  Json attributes = {{"POSITION", file.attribute(&mesh.positions[0].x, n, 3, 3, true)}};
  if (!mesh.normals.empty()) attributes["NORMAL"] = file.attribute(&mesh.normals[0].x, n, 3, 3);
  if (!mesh.tangents.empty()) attributes["TANGENT"] = file.attribute(&mesh.tangents[0].x, n, 4, 4);
  for (int set = 0; set < 2 && !mesh.uv[set].empty(); ++set)
    attributes[set == 0 ? "TEXCOORD_0" : "TEXCOORD_1"] = file.attribute(&mesh.uv[set][0].x, n, 2, 2);
  if (!mesh.colours.empty()) attributes["COLOR_0"] = colours(file, mesh.colours);
  const std::span<const uint32_t> corners(mesh.triangles[0].data(), 3 * mesh.triangles.size());
  return {{"attributes", std::move(attributes)}, {"indices", file.indices(corners, n)}};
}

Mesh transformed(const Mesh& mesh, const Mat4& to_world) {
  Mesh out = mesh;
  const Mat3 linear(to_world);
  // Cofactors: the inverse transpose times the determinant, defined for flattening matrices too.
  const Mat3 cofactors(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
  const bool mirrors = glm::determinant(linear) < 0;
  for (Point3& p : out.positions) p = transform_point(to_world, p);
  for (Vec3& n : out.normals) n = normalize_or((mirrors ? -1.0f : 1.0f) * (cofactors * n), Vec3(0, 1, 0));
  for (Vec4& t : out.tangents) t = Vec4(normalize_or(linear * Vec3(t), Vec3(1, 0, 0)), mirrors ? -t.w : t.w);
  if (mirrors)
    for (auto& triangle : out.triangles) std::swap(triangle[1], triangle[2]);
  return out;
}

}  // namespace aktina::gltf_export
