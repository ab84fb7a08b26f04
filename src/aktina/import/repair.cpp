#include "aktina/import/repair.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr float kFarthest = 1e15f;       // m; products of three such lengths are still finite
constexpr float kUnitTolerance = 0.02f;  // of a normal's length: 8-bit normals are that coarse

bool usable(Point3 p) { return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest; }

class MeshRepair {
 public:
  MeshRepair(Mesh& mesh, Warnings& warnings) : mesh_(mesh), warnings_(warnings) {}

  void drop_triangles(bool stitched) {
    uint64_t beyond = 0, unusable = 0, flat = 0;
    size_t kept = 0;
    for (size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto t = mesh_.triangles[i];
      if (std::max({t[0], t[1], t[2]}) >= mesh_.positions.size()) {
        ++beyond;
      } else if (!usable(mesh_.positions[t[0]]) || !usable(mesh_.positions[t[1]]) || !usable(mesh_.positions[t[2]])) {
        ++unusable;
      } else if (has_no_area(t)) {
        if (!stitched || (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])) ++flat;
      } else {
        if (!mesh_.triangle_face.empty()) mesh_.triangle_face[kept] = mesh_.triangle_face[i];
        mesh_.triangles[kept++] = t;
      }
    }
    mesh_.triangles.resize(kept);
    if (!mesh_.triangle_face.empty()) mesh_.triangle_face.resize(kept);
    forget_plain_faces();
    warn(beyond, "triangles with vertex indices out of range were dropped");
    warn(unusable, "triangles with positions that are not finite or beyond 1e15 m were dropped");
    warn(flat, "triangles without area were dropped");
  }

  void drop_vertices() {
    std::vector<uint32_t> place(mesh_.positions.size(), 0);
    for (const auto& t : mesh_.triangles) place[t[0]] = place[t[1]] = place[t[2]] = 1;
    if (std::find(place.begin(), place.end(), 0u) == place.end()) return;
    const auto keep = [&](auto& list) {
      size_t kept = 0;
      for (size_t i = 0; i < list.size(); ++i)
        if (place[i]) list[kept++] = list[i];
      list.resize(kept);
    };
    keep(mesh_.positions), keep(mesh_.normals), keep(mesh_.tangents);
    keep(mesh_.uv[0]), keep(mesh_.uv[1]), keep(mesh_.colours);
    uint32_t next = 0;
    for (uint32_t& p : place) p = p ? next++ : 0;
    for (auto& t : mesh_.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  }

  void mend_normals() {
    uint64_t mended = 0, replaced = 0;
    std::vector<uint32_t> lost;
    for (uint32_t i = 0; i < mesh_.normals.size(); ++i) {
      Vec3& n = mesh_.normals[i];
      const float l = length(n);
      if (!(l > 1e-6f && l < kFarthest)) {
        lost.push_back(i);
      } else {
        if (std::abs(l - 1) > kUnitTolerance) ++mended;
        n *= 1 / l;
      }
    }
    replaced = lost.size();
    if (!lost.empty()) replace_normals(lost);
    warn(mended, "normals that were not of unit length were normalized");
    warn(replaced, "normals that were zero or not finite were replaced by those of the faces");
  }

  void mend_tangents() {
    uint64_t replaced = 0;
    for (size_t i = 0; i < mesh_.tangents.size(); ++i) {
      Vec4& t = mesh_.tangents[i];
      const Vec3 direction = normalize_or(Vec3(t), Vec3(0));
      if (direction == Vec3(0)) ++replaced;
      t = Vec4(direction == Vec3(0) ? Frame(mesh_.normals[i]).t : direction, t.w < 0 ? -1 : 1);
    }
    warn(replaced, "tangents that were zero or not finite were replaced");
  }

  void mend_values() {
    uint64_t uv = 0, colours = 0;
    for (auto& set : mesh_.uv)
      for (Vec2& v : set)
        if (!is_finite(Vec3(v, 0))) v = Vec2(0), ++uv;
    for (Vec4& c : mesh_.colours)
      if (!is_finite(Vec3(c)) || !std::isfinite(c.w)) c = Vec4(1), ++colours;
    warn(uv, "texture coordinates that were not finite were set to 0");
    warn(colours, "vertex colours that were not finite were set to white");
  }

 private:
  /// Where each triangle is its own face, none are stated.
  void forget_plain_faces() {
    auto& faces = mesh_.triangle_face;
    for (uint32_t i = 0; i < faces.size(); ++i)
      if (faces[i] != i) return;
    if (mesh_.face_count == faces.size()) faces = {};
  }

  bool has_no_area(const std::array<uint32_t, 3>& t) const {
    const Vec3d a(mesh_.positions[t[0]]);
    const Vec3d n = cross(Vec3d(mesh_.positions[t[1]]) - a, Vec3d(mesh_.positions[t[2]]) - a);
    return n == Vec3d(0);
  }

  void replace_normals(const std::vector<uint32_t>& lost) {
    std::vector<bool> wanted(mesh_.normals.size(), false);
    for (const uint32_t i : lost) wanted[i] = true, mesh_.normals[i] = Vec3(0);
    for (const auto& t : mesh_.triangles)
      for (const uint32_t i : t)
        if (wanted[i]) mesh_.normals[i] += normalize_or(triangle_cross(mesh_, t), Vec3(0));
    for (const uint32_t i : lost) mesh_.normals[i] = normalize_or(mesh_.normals[i], {0, 1, 0});
  }

  void warn(uint64_t count, const char* text) {
    if (count > 0) warnings_.add(text, count);
  }

  Mesh& mesh_;
  Warnings& warnings_;
};

}  // namespace

void repair(Mesh& mesh, Warnings& warnings, bool stitched) {
  MeshRepair work(mesh, warnings);
  work.drop_triangles(stitched);
  work.drop_vertices();
  work.mend_normals();
  if (mesh.normals.empty()) mesh.tangents.clear();
  work.mend_tangents();
  work.mend_values();
}

void generate_tangents(Mesh& mesh, int uv_set) {
  const std::vector<Vec2>& uv = mesh.uv[uv_set];
  if (!mesh.tangents.empty() || uv.empty() || mesh.normals.empty()) return;
  std::vector<Vec3> along_u(mesh.positions.size(), Vec3(0)), along_v = along_u;
  for (const auto& t : mesh.triangles) {
    const Vec3 e1 = mesh.positions[t[1]] - mesh.positions[t[0]], e2 = mesh.positions[t[2]] - mesh.positions[t[0]];
    const Vec2 d1 = uv[t[1]] - uv[t[0]], d2 = uv[t[2]] - uv[t[0]];
    const float side = d1.x * d2.y - d2.x * d1.y < 0 ? -1.0f : 1.0f;
    for (const uint32_t i : t) {
      along_u[i] += side * (e1 * d2.y - e2 * d1.y);
      along_v[i] += side * (e2 * d1.x - e1 * d2.x);
    }
  }
  mesh.tangents.resize(mesh.positions.size());
  for (size_t i = 0; i < mesh.tangents.size(); ++i) {
    const Vec3 n = mesh.normals[i];
    const Vec3 t = normalize_or(along_u[i] - n * dot(n, along_u[i]), Frame(n).t);
    // glTF's bitangent, cross(n, t) * w, points up the picture, where v falls
    mesh.tangents[i] = Vec4(t, dot(cross(n, t), along_v[i]) > 0 ? -1.0f : 1.0f);
  }
}

}  // namespace aktina
