#include <map>
#include <tuple>

#include "aktina/base/error.h"
#include "aktina/radiosity/lightmap/lightmap.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

/// Textures of materials that stand on the second coordinates move to the first, as the lightmap takes the second.
class CoordinateSets {
 public:
  explicit CoordinateSets(Scene& scene) {
    for (Material& m : scene.materials) {
      const bool second = moved_.emplace_back(uses(m, 1));
      if (!second) continue;
      if (uses(m, 0))
        throw Error(Code::unsupported, m.name.empty() ? "material" : m.name,
                    "its textures use both sets of texture coordinates, none is left for a lightmap",
                    "vertex colours need none: --as vertex");
      for (Texture* const t : textures(m)) t->uv_set = 0;
    }
  }
  /// The source's set that becomes the first of a mesh with this material.
  int first_of(int material) const { return material >= 0 && moved_[size_t(material)] ? 1 : 0; }

 private:
  static std::array<Texture*, 8> textures(Material& m) {
    return {&m.base_texture,     &m.metallic_roughness_texture, &m.normal_texture,   &m.occlusion_texture,
            &m.emission_texture, &m.transmission_texture,       &m.specular_texture, &m.specular_tint_texture};
  }
  static bool uses(Material& m, int set) {
    for (const Texture* const t : textures(m))
      if (*t && t->uv_set == set) return true;
    return false;
  }
  std::vector<bool> moved_;
};

/// One side of an instance on one page, as a mesh in the instance's own space.
class PageMesh {
 public:
  /// @param first_set  of the source's texture coordinates, to be kept as the first
  PageMesh(const Mesh& source, bool back, int first_set) : source_(source), first_(source.uv[first_set]), back_(back) {
    mesh_.name = source.name, mesh_.material = source.material;
  }

  void add(const PlacedChart& chart, const LightmapSurface& surface, const LightmapLayout::Page& page) {
    const Vec2 scale(1 / float(page.width), 1 / float(page.height));
    std::map<std::tuple<uint32_t, float, float>, uint32_t>
        ids;  // a vertex stands once in a chart, or twice at its seam
    for (size_t i = 0; i < chart.triangles.size(); ++i) {
      const auto& t = source_.triangles[surface.sources[chart.triangles[i]]];
      std::array<uint32_t, 3> corners;
      for (size_t k = 0; k < 3; ++k) {
        const Vec2 uv = chart.texels[i][k] * scale;
        const auto [at, is_new] = ids.try_emplace({t[k], uv.x, uv.y}, uint32_t(mesh_.positions.size()));
        if (is_new) copy(t[k], uv);
        corners[k] = at->second;
      }
      if (back_) std::swap(corners[1], corners[2]);
      mesh_.triangles.push_back(corners);
    }
  }
  Mesh finish() { return std::move(mesh_); }

 private:
  void copy(uint32_t v, Vec2 uv) {
    const float side = back_ ? -1.0f : 1.0f;
    mesh_.positions.push_back(source_.positions[v]);
    if (!source_.normals.empty()) mesh_.normals.push_back(side * source_.normals[v]);
    if (!source_.tangents.empty()) mesh_.tangents.push_back(source_.tangents[v] * Vec4(1, 1, 1, side));
    if (!source_.colours.empty()) mesh_.colours.push_back(source_.colours[v]);
    mesh_.uv[0].push_back(first_.empty() ? uv : first_[v]);  // glTF wants a first set where there is a second
    mesh_.uv[1].push_back(uv);
  }

  const Mesh& source_;
  const std::vector<Vec2>& first_;
  bool back_;
  Mesh mesh_;
};

}  // namespace

LightmappedScene lightmapped_scene(const Scene& scene, const Lightmap& lightmap) {
  const TessellatedScene tessellated(scene);
  const LightmapLayout& layout = lightmap.layout;
  LightmappedScene out;
  out.scene = *tessellated;
  out.scene.meshes.clear(), out.scene.instances.clear();
  const CoordinateSets sets(out.scene);
  std::map<std::pair<uint32_t, int>, PageMesh> meshes;  // of surface and page
  for (const PlacedChart& chart : layout.charts) {
    const LightmapSurface& surface = layout.surfaces[chart.surface];
    const Instance& instance = tessellated->instances[surface.instance];
    const Mesh& source = tessellated->meshes[size_t(instance.mesh)];
    const int material = instance.material >= 0 ? instance.material : source.material;
    const auto at =
        meshes.try_emplace({chart.surface, chart.page}, source, surface.back, sets.first_of(material)).first;
    at->second.add(chart, surface, layout.pages[size_t(chart.page)]);
  }
  for (auto& [key, mesh] : meshes) {
    const LightmapSurface& surface = layout.surfaces[key.first];
    Instance instance = tessellated->instances[surface.instance];
    instance.mesh = int(out.scene.meshes.size());
    out.scene.meshes.push_back(mesh.finish());
    out.scene.instances.push_back(instance);
    out.pages.push_back(key.second);
    out.backs.push_back(surface.back);
    out.sources.push_back(surface.instance);
  }
  return out;
}

}  // namespace aktina
