#include "aktina/radiosity/lightmap/surface.h"

#include "aktina/radiosity/mesher/source_faces.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

void add_triangle(LightmapSurface& s, const Scene& scene, const SourceFaces& faces, uint32_t source) {
  const Instance& instance = scene.instances[s.instance];
  const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
  const auto& t = mesh.triangles[source];
  std::array<Point3, 3> corners;
  std::array<Vec3, 3> normals;
  for (uint32_t k = 0; k < 3; ++k) {
    corners[k] = transform_point(instance.to_world, mesh.positions[t[k]]);
    normals[k] = faces.normal({s.instance, source, k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f});
  }
  const bool mirrored = glm::determinant(Mat3(instance.to_world)) < 0;
  const Vec3 twice = cross(corners[1] - corners[0], corners[2] - corners[0]) * (mirrored ? -1.0f : 1.0f);
  s.sources.push_back(source);
  s.corners.push_back(corners);
  s.normals.push_back(normals);
  s.facing.push_back(normalize_or(twice, normals[0]));
  s.areas.push_back(0.5f * length(twice));
  if (!mesh.uv[1].empty()) s.given.push_back({mesh.uv[1][t[0]], mesh.uv[1][t[1]], mesh.uv[1][t[2]]});
}

void number_places(LightmapSurface& s) {
  std::vector<Point3> points;
  for (const auto& c : s.corners) points.insert(points.end(), c.begin(), c.end());
  const std::vector<uint32_t> same = weld(points);
  for (size_t t = 0; t < s.size(); ++t) s.places.push_back({same[3 * t], same[3 * t + 1], same[3 * t + 2]});
}

LightmapSurface front(const Scene& scene, uint32_t instance) {
  LightmapSurface s;
  s.instance = instance;
  const SourceFaces faces(scene, instance);
  for (const SourceFace& face : faces.list) {
    add_triangle(s, scene, faces, face.triangles[0]);
    if (face.triangles[1] != face.triangles[0]) add_triangle(s, scene, faces, face.triangles[1]);
  }
  number_places(s);
  return s;
}

LightmapSurface back_of(LightmapSurface s) {
  s.back = true;
  for (Vec3& n : s.facing) n = -n;
  for (auto& normals : s.normals)
    for (Vec3& n : normals) n = -n;
  return s;
}

}  // namespace

std::vector<LightmapSurface> lightmap_surfaces(const Scene& scene, const Solution& solution) {
  std::vector<LightmapSurface> surfaces;
  const PatchMesh& mesh = solution.mesh;
  for (size_t first = 0, end = 0; first < mesh.size(); first = end) {
    const uint32_t instance = mesh.centres[first].instance;
    while (end < mesh.size() && mesh.centres[end].instance == instance) ++end;
    surfaces.push_back(front(scene, instance));
    if (mesh.two_sided[first]) surfaces.push_back(back_of(surfaces.back()));
  }
  return surfaces;
}

}  // namespace aktina
