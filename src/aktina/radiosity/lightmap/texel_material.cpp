#include "aktina/radiosity/lightmap/texel_material.h"

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

template <class T>
T blend(const std::vector<T>& values, const std::array<uint32_t, 3>& t, Vec2 uv, T none) {
  return values.empty() ? none : values[t[0]] * (1 - uv.x - uv.y) + values[t[1]] * uv.x + values[t[2]] * uv.y;
}

class Surfaces {
 public:
  Surfaces(const Scene& scene, const LightmapLayout& layout) : scene_(scene), layout_(layout) {}

  void at(const LightmapTexel& texel, Rgb& reflectance, Radiance& emission) const {
    const PlacedChart& chart = layout_.charts[texel.chart];
    const LightmapSurface& surface = layout_.surfaces[chart.surface];
    const Instance& instance = scene_.instances[surface.instance];
    const Mesh& mesh = scene_.meshes[size_t(instance.mesh)];
    const auto& t = mesh.triangles[surface.sources[chart.triangles[texel.triangle]]];
    const FlatTriangle& flat = chart.texels[texel.triangle];
    for (int k = 0; k < 4; ++k) {
      const Vec2 p(float(texel.x) + (k % 2 ? 0.75f : 0.25f), float(texel.y) + (k / 2 ? 0.75f : 0.25f));
      const Vec2 at = nearest_on_triangle(flat, p);
      const Vec2 uv[2] = {blend(mesh.uv[0], t, at, Vec2(0)), blend(mesh.uv[1], t, at, Vec2(0))};
      const MaterialPoint point =
          evaluate(scene_, scene_.material_of(instance), uv, blend(mesh.colours, t, at, Vec4(1)));
      reflectance += matt_reflectance(point.surface) * 0.25f;
      emission += point.emission * 0.25f;
    }
  }

 private:
  const Scene& scene_;
  const LightmapLayout& layout_;
};

}  // namespace

TexelMaterials texel_materials(const Scene& scene, const LightmapLayout& layout,
                               std::span<const LightmapTexel> texels) {
  TexelMaterials out;
  out.reflectances.resize(texels.size()), out.emissions.resize(texels.size());
  const Surfaces surfaces(scene, layout);
  parallel_for(texels.size(), 1024, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) surfaces.at(texels[i], out.reflectances[i], out.emissions[i]);
  });
  return out;
}

}  // namespace aktina
