// A solution as geometry with vertex colours: what any viewer shows without computing light.
#include <algorithm>
#include <map>

#include "aktina/radiosity/display/patch_scene.h"
#include "aktina/radiosity/solve.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

/// The unlit stand-in of a material: what H / pi is multiplied by to become radiance.
Material unlit_material(const Material& m) {
  Material lit;
  lit.name = m.name;
  lit.unlit = true;
  lit.double_sided = false;  // the backs of two-sided surfaces are triangles of their own
  lit.alpha = m.alpha, lit.alpha_mode = m.alpha_mode, lit.alpha_cutoff = m.alpha_cutoff;
  if (m.emits()) return lit;  // vertex colours carry the radiance
  lit.base_texture = m.base_texture;
  lit.base_colour = m.unlit ? m.base_colour : matt_reflectance(m);
  return lit;
}

template <class T>
T blend(const std::vector<T>& values, const std::array<uint32_t, 3>& t, const SurfacePoint& at) {
  return values[t[0]] * (1 - at.u - at.v) + values[t[1]] * at.u + values[t[2]] * at.v;
}

/// The patches of one instance as a mesh in its own space.
class LitMesh {
 public:
  LitMesh(const Scene& scene, const Solution& solution, uint32_t instance)
      : solution_(solution),
        source_(scene.meshes[size_t(scene.instances[instance].mesh)]),
        emits_(scene.material_of(scene.instances[instance]).emits()),
        unlit_(scene.material_of(scene.instances[instance]).unlit),
        to_local_(glm::inverse(scene.instances[instance].to_world)),
        normal_to_local_(glm::transpose(Mat3(scene.instances[instance].to_world))),
        mirrored_(glm::determinant(Mat3(scene.instances[instance].to_world)) < 0) {
    mesh_.name = source_.name;
  }

  void add(uint32_t patch) {
    const auto& corners = solution_.mesh.patches[patch];
    std::array<uint32_t, 4> front, back;
    for (size_t k = 0; k < 4; ++k) front[k] = vertex(corners[k], false);
    add(front, solution_.mesh.is_quad(patch));
    if (!solution_.mesh.two_sided[patch]) return;
    for (size_t k = 0; k < 4; ++k) back[k] = vertex(corners[k], true);
    std::swap(back[1], back[solution_.mesh.is_quad(patch) ? 3 : 2]);
    if (!solution_.mesh.is_quad(patch)) back[3] = back[2];
    add(back, solution_.mesh.is_quad(patch));
  }
  Mesh finish() { return std::move(mesh_); }

 private:
  /// Quadrilaterals are split where the light changes less: fewer Mach bands.
  void add(const std::array<uint32_t, 4>& c, bool quad) {
    if (!quad) return add_triangle(c[0], c[1], c[2]);
    const auto step = [&](size_t i, size_t k) { return length(Vec3(mesh_.colours[c[i]] - mesh_.colours[c[k]])); };
    if (step(0, 2) <= step(1, 3)) {
      add_triangle(c[0], c[1], c[2]), add_triangle(c[0], c[2], c[3]);
    } else {
      add_triangle(c[1], c[2], c[3]), add_triangle(c[1], c[3], c[0]);
    }
  }
  void add_triangle(uint32_t a, uint32_t b, uint32_t c) {
    if (mirrored_) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  uint32_t vertex(uint32_t v, bool back) {
    const auto [at, is_new] = ids_.try_emplace({v, back}, uint32_t(mesh_.positions.size()));
    if (!is_new) return at->second;
    const PatchMesh& patches = solution_.mesh;
    const SurfacePoint place = patches.places[v];
    const auto& t = source_.triangles[place.triangle];
    mesh_.positions.push_back(transform_point(to_local_, patches.positions[v]));
    mesh_.normals.push_back(normalize_or(normal_to_local_ * patches.normals[v], {0, 1, 0}) * (back ? -1.0f : 1.0f));
    for (size_t set = 0; set < 2; ++set)
      if (!source_.uv[set].empty()) mesh_.uv[set].push_back(blend(source_.uv[set], t, place));
    Vec4 own = source_.colours.empty() || emits_ ? Vec4(1) : blend(source_.colours, t, place);
    const Rgb light = colour(v, back);
    mesh_.colours.push_back({light.r * own.x, light.g * own.y, light.b * own.z, own.w});
    return at->second;
  }

  /// H / pi; of what emits, its whole radiance; of what is unlit already, nothing more than it is.
  Rgb colour(uint32_t v, bool back) const {
    const Rgb h = (back ? solution_.vertex_back_irradiances : solution_.vertex_irradiances)[v].v;
    if (unlit_ && !emits_) return Rgb(1);
    if (!emits_) return h * float(kInvPi);
    return lambertian_radiance(solution_.vertex_radiosities[v]).v;
  }

  const Solution& solution_;
  const Mesh& source_;
  bool emits_, unlit_;
  Mat4 to_local_;
  Mat3 normal_to_local_;
  bool mirrored_;
  Mesh mesh_;
  std::map<std::pair<uint32_t, bool>, uint32_t> ids_;
};

}  // namespace

Scene lit_scene(const Scene& scene, const Solution& solution) {
  const TessellatedScene tessellated(scene);
  check_places(*tessellated, solution);
  Scene lit = *tessellated;
  lit.meshes.clear();
  for (Material& material : lit.materials) material = unlit_material(material);
  std::vector<bool> has_patches(lit.instances.size(), false);
  const PatchMesh& mesh = solution.mesh;
  for (size_t first = 0, end = 0; first < mesh.size(); first = end) {
    const uint32_t index = mesh.centres[first].instance;
    LitMesh part(*tessellated, solution, index);
    for (; end < mesh.size() && mesh.centres[end].instance == index; ++end) part.add(uint32_t(end));
    Instance& instance = lit.instances[index];
    has_patches[index] = true;
    const int material =
        instance.material >= 0 ? instance.material : tessellated->meshes[size_t(instance.mesh)].material;
    instance.mesh = int(lit.meshes.size()), instance.material = -1;
    lit.meshes.push_back(part.finish());
    lit.meshes.back().material = material;
    if (material >= 0) continue;
    lit.meshes.back().material = int(lit.materials.size());  // the material that stands in where none is given
    lit.materials.push_back(unlit_material(tessellated->material_of(tessellated->instances[index])));
  }
  std::vector<Instance> kept;
  for (size_t i = 0; i < lit.instances.size(); ++i)
    if (has_patches[i]) kept.push_back(lit.instances[i]);
  lit.instances = std::move(kept);
  return lit;
}

}  // namespace aktina
