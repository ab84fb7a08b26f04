#include "aktina/radiosity/mesher/patch_material.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr int kMostSamples = 16;  // along a side of a patch

bool has_textures(const Material& m) {
  return m.base_texture || m.metallic_roughness_texture || m.emission_texture || m.transmission_texture ||
         m.specular_texture || m.specular_tint_texture;
}

}  // namespace

PatchMaterials::PatchMaterials(const Scene& scene, const Instance& instance, const SourceFaces& faces)
    : scene_(scene),
      material_(scene.material_of(instance)),
      faces_(faces),
      uniform_(!has_textures(material_) && scene.meshes[size_t(instance.mesh)].colours.empty()) {
  if (uniform_) everywhere_ = at({});
}

PatchMaterial PatchMaterials::at(const SurfacePoint& place) const {
  Vec2 uv[2] = {Vec2(0), Vec2(0)};
  Vec4 colour(1);
  if (!uniform_) uv[0] = faces_.uv(place, 0), uv[1] = faces_.uv(place, 1), colour = faces_.colour(place);
  const MaterialPoint point = evaluate(scene_, material_, uv, colour);
  PatchMaterial m;
  m.reflectance = matt_reflectance(point.surface) * point.alpha;
  m.transmittance = point.surface.kt * point.alpha + Rgb(1 - point.alpha);
  m.emission = lambertian_radiosity(point.emission * point.alpha);
  return m;
}

/// Along a side: as many as there are texels, within reason.
int PatchMaterials::samples(const SourceFace& face, std::span<const Point3, 4> corners) const {
  if (uniform_) return 1;
  float texels = 2;
  for (const Texture* use : {&material_.base_texture, &material_.emission_texture}) {
    if (!*use) continue;
    const TextureImage& image = scene_.images[size_t(use->image)];
    const Vec2 size = use->scale * Vec2(float(image.width()), float(image.height()));
    Vec2 last = faces_.uv(faces_.place(face, corners[3]), use->uv_set);
    for (const Point3 corner : corners) {
      const Vec2 next = faces_.uv(faces_.place(face, corner), use->uv_set);
      texels = std::max(texels, length((next - last) * size) - 0.01f);
      last = next;
    }
  }
  return int(std::min(std::ceil(texels), float(kMostSamples)));
}

PatchMaterial PatchMaterials::average(const SourceFace& face, std::span<const Point3, 4> corners) const {
  PatchMaterial mean = everywhere_;
  const int n = samples(face, corners);
  if (!uniform_) mean = {};
  for (int j = 0; j < n && !uniform_; ++j)
    for (int i = 0; i < n; ++i) {
      // Of a triangle, whose last corners coincide, this is a map of the square that keeps areas only roughly; the
      // weight is its determinant.
      const float u = (float(i) + 0.5f) / float(n), v = (float(j) + 0.5f) / float(n);
      const bool quad = corners[2] != corners[3];
      const Point3 p =
          quad ? (corners[0] * (1 - u) + corners[1] * u) * (1 - v) + (corners[3] * (1 - u) + corners[2] * u) * v
               : corners[0] * (1 - u) + (corners[1] * (1 - v) + corners[2] * v) * u;
      const float weight = quad ? 1 : 2 * u;
      const PatchMaterial m = at(faces_.place(face, p));
      mean.reflectance += m.reflectance * weight, mean.transmittance += m.transmittance * weight;
      mean.emission += m.emission * weight;
    }
  if (!uniform_) {
    const float share = 1 / float(n * n);
    mean.reflectance *= share, mean.transmittance *= share, mean.emission = mean.emission * share;
  }
  for (int c = 0; c < 3; ++c) {
    const float most = kMostReflectance * std::max(0.0f, 1 - mean.transmittance[c]);
    if (mean.reflectance[c] <= most * (1 + 1e-5f)) continue;
    mean.clamped = true;
    mean.reflectance[c] = most;
  }
  return mean;
}

}  // namespace aktina
