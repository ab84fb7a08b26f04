#include "aktina/radiosity/solver/adaptive_direct.h"

#include <algorithm>

#include "aktina/base/statistics.h"
#include "aktina/radiosity/mesher/quadtree_forest.h"
#include "aktina/radiosity/solver/reconstruct.h"
#include "aktina/radiosity/solver/shooter_hits.h"

namespace aktina {
namespace {

constexpr uint32_t kNew = QuadtreeForest::kNew;

/// Values of sides that stay, in their new order; the others are left to be computed.
std::vector<uint32_t> keep(const Sides& before, const Sides& now, const std::vector<uint32_t>& origin,
                           DirectLight& light) {
  const std::vector<uint32_t> was = now.origins(before, origin, kNew);
  DirectLight kept{std::vector<Rgb>(now.size(), Rgb(0)), std::vector<Rgb>(now.size(), Rgb(0))};
  std::vector<uint32_t> missing;
  for (uint32_t s = 0; s < now.size(); ++s) {
    if (was[s] == kNew)
      missing.push_back(s);
    else
      kept.lamps[s] = light.lamps[was[s]], kept.all[s] = light.all[was[s]];
  }
  light = std::move(kept);
  return missing;
}

double mean_luminance(const Sides& sides, std::span<const Rgb> light) {
  Sum sum, area;
  for (size_t s = 0; s < sides.size(); ++s) {
    const double a = double(sides.mesh().areas[sides.patch(s)]);
    sum.add(a * double(luminance(light[s]))), area.add(a);
  }
  return area.value() > 0 ? sum.value() / area.value() : 0;
}

void mark(const PatchMesh& mesh, const Reconstruction& reconstruction, std::span<const Irradiance> values, double mean,
          double most, std::vector<uint8_t>& marks) {
  const std::vector<Irradiance> corners = reconstruction.at_vertices(values);
  for (size_t i = 0; i < mesh.size(); ++i) {
    float low = 1e30f, high = 0;
    for (const uint32_t v : mesh.patches[i]) {
      const float l = luminance(corners[v].v);
      low = std::min(low, l), high = std::max(high, l);
    }
    if (double(high - low) > most * std::max(mean, double(luminance(values[i].v)))) marks[i] = 1;
  }
}

}  // namespace

std::vector<uint8_t> steep_patches(const Sides& sides, std::span<const Rgb> light, double most) {
  const PatchMesh& mesh = sides.mesh();
  std::vector<Irradiance> front(mesh.size()), back(mesh.size());
  for (size_t s = 0; s < sides.size(); ++s) (sides.is_back(s) ? back : front)[sides.patch(s)].v = light[s];
  std::vector<uint8_t> marks(mesh.size(), 0);
  const Reconstruction reconstruction(mesh);
  const double mean = mean_luminance(sides, light);
  mark(mesh, reconstruction, front, mean, most, marks);
  if (sides.size() > mesh.size()) mark(mesh, reconstruction, back, mean, most, marks);
  return marks;
}

DirectLight refine_by_direct_light(const Scene& scene, const Visibility& visibility, const Refinement& refinement,
                                   const RadiosityOptions& options, const MeshOptions& mesh_options, PatchMesh& mesh,
                                   KeptDirectLight& kept, Progress* progress) {
  QuadtreeForest forest(scene, std::move(mesh), options.most_patches);
  const LightGroup lights = all_lights(scene);
  DirectLight light;
  PatchMesh current = forest.mesh();
  std::vector<uint32_t> missing = Sides(current).all();
  for (int level = 0; !missing.empty(); ++level) {
    const Sides sides(current);
    const std::vector<float> open = ShooterHits(sides).open_shares();
    DirectSources(lights, sides, open, visibility, options, mesh_options).shine_on(missing, light, kept, progress);
    missing.clear();
    if (level == refinement.depth || (progress && progress->cancelled())) break;
    const std::vector<uint32_t> origin =
        forest.refine(steep_patches(sides, light.all, refinement.gradient * options.target_error), refinement.depth);
    if (origin.empty()) break;
    PatchMesh next = forest.mesh();
    missing = keep(sides, Sides(next), origin, light);
    current = std::move(next);
  }
  mesh = std::move(current);
  return light;
}

}  // namespace aktina
