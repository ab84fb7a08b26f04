#include "aktina/radiosity/display/patch_scene.h"

#include <algorithm>
#include <unordered_map>

#include "aktina/base/error.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

template <class T>
void push_blend(std::vector<T>& to, const std::vector<T>& from, const std::array<uint32_t, 3>& t, SurfacePoint at) {
  if (!from.empty()) to.push_back(from[t[0]] * (1 - at.u - at.v) + from[t[1]] * at.u + from[t[2]] * at.v);
}

/// Patches [first, end) as a mesh in the space of their instance.
Mesh patch_mesh(const Scene& scene, const PatchMesh& patches, size_t first, size_t end,
                std::vector<std::array<uint32_t, 3>>& vertices) {
  const Instance& instance = scene.instances[patches.centres[first].instance];
  const Mesh& source = scene.meshes[size_t(instance.mesh)];
  const Mat4 to_local = glm::inverse(instance.to_world);
  const Mat3 normal_to_local = glm::transpose(Mat3(instance.to_world));
  const bool mirrored = glm::determinant(Mat3(instance.to_world)) < 0;
  Mesh mesh;
  mesh.name = source.name, mesh.material = source.material;
  std::unordered_map<uint32_t, uint32_t> ids;
  const auto vertex = [&](uint32_t v) {
    const auto [at, is_new] = ids.try_emplace(v, uint32_t(mesh.positions.size()));
    if (!is_new) return at->second;
    const SurfacePoint place = patches.places[v];
    const auto& t = source.triangles[place.triangle];
    mesh.positions.push_back(transform_point(to_local, patches.positions[v]));
    mesh.normals.push_back(normalize_or(normal_to_local * patches.normals[v], {0, 1, 0}));
    push_blend(mesh.uv[0], source.uv[0], t, place), push_blend(mesh.uv[1], source.uv[1], t, place);
    push_blend(mesh.tangents, source.tangents, t, place), push_blend(mesh.colours, source.colours, t, place);
    return at->second;
  };
  const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
    if (mirrored) std::swap(b, c);
    mesh.triangles.push_back({vertex(a), vertex(b), vertex(c)});
    vertices.push_back({a, b, c});
  };
  for (size_t i = first; i < end; ++i) {
    const auto& c = patches.patches[i];
    add(c[0], c[1], c[2]);
    if (patches.is_quad(i)) add(c[0], c[2], c[3]);
  }
  return mesh;
}

}  // namespace

void check_places(const Scene& scene, const Solution& solution) {
  const auto lies_on_scene = [&](const SurfacePoint& at) {
    if (at.instance >= scene.instances.size() || scene.instances[at.instance].mesh < 0) return false;
    return at.triangle < scene.meshes[size_t(scene.instances[at.instance].mesh)].triangles.size();
  };
  const PatchMesh& mesh = solution.mesh;
  if (!std::all_of(mesh.centres.begin(), mesh.centres.end(), lies_on_scene) ||
      !std::all_of(mesh.places.begin(), mesh.places.end(), lies_on_scene))
    throw Error(Code::usage, scene.source, "the solution is of another scene", "solve this scene again");
}

PatchScene::PatchScene(const Scene& original, const Solution& solution) {
  const TessellatedScene tessellated(original);
  check_places(*tessellated, solution);
  const PatchMesh& patches = solution.mesh;
  scene = *tessellated;
  scene.meshes.clear();
  vertices.resize(scene.instances.size());
  std::vector<bool> has_patches(scene.instances.size(), false);
  for (size_t first = 0, end = 0; first < patches.size(); first = end) {
    const uint32_t index = patches.centres[first].instance;
    while (end < patches.size() && patches.centres[end].instance == index) ++end;
    Mesh mesh = patch_mesh(*tessellated, patches, first, end, vertices[index]);
    scene.instances[index].mesh = int(scene.meshes.size());
    scene.meshes.push_back(std::move(mesh));
    has_patches[index] = true;
  }
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    if (has_patches[i]) continue;
    scene.instances[i].mesh = int(scene.meshes.size());  // nothing but degenerate triangles
    scene.meshes.emplace_back();
  }
}

}  // namespace aktina
