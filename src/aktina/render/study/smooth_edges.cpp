// Where triangles of a smooth surface meet in a picture, and what happens to the light there.
#include <array>
#include <cmath>

#include "aktina/base/statistics.h"
#include "aktina/render/study/quality.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr float kSameNormal = 0.9999f;  // cosine: normals less than 0.8 degrees apart are one

/// A triangle's corners: which places they stand in, and their normals.
struct Corners {
  std::array<uint32_t, 3> place;
  std::array<Vec3, 3> normal;
};

/// All triangles, in the order of item buffers.
std::vector<Corners> corners_of(const Scene& scene) {
  std::vector<Corners> all;
  uint32_t first = 0;
  for (const Instance& instance : scene.instances) {
    if (instance.mesh < 0) continue;
    const Mesh& mesh = scene.meshes[size_t(instance.mesh)];
    const std::vector<uint32_t> place = weld(mesh.positions);
    for (const auto& t : mesh.triangles) {
      Corners& c = all.emplace_back();
      for (size_t k = 0; k < 3; ++k) {
        c.place[k] = first + place[t[k]];
        c.normal[k] = mesh.normals.empty() ? Vec3(0) : mesh.normals[t[k]];
      }
    }
    first += uint32_t(mesh.positions.size());
  }
  return all;
}

bool meet_smoothly(const Corners& a, const Corners& b) {
  int shared = 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) shared += a.place[i] == b.place[j] && dot(a.normal[i], b.normal[j]) > kSameNormal;
  return shared >= 2;
}

}  // namespace

SmoothEdges::SmoothEdges(const Scene& scene, const Camera& camera, int width, int height) {
  const ItemRasterizer rasterizer(scene);
  ItemBuffer items;
  rasterizer.draw(camera, width, height, items);
  const std::vector<Corners> corners = corners_of(scene);
  for (const uint32_t item : items.item) covered_ += item != ItemBuffer::kNothing;

  const auto look = [&](size_t first, size_t step) {
    const uint32_t a = items.item[first], b = items.item[first + 3 * step];
    if (a == b || a == ItemBuffer::kNothing || b == ItemBuffer::kNothing) return;
    if (items.item[first + step] != a || items.item[first + 2 * step] != b) return;
    if (meet_smoothly(corners[a], corners[b])) places_.push_back({first, step});
  };
  const auto w = size_t(width), h = size_t(height);
  for (size_t y = 0; y < h; ++y)
    for (size_t x = 0; x < w; ++x) {
      if (x + 3 < w) look(y * w + x, 1);
      if (y + 3 < h) look(y * w + x, w);
    }
}

void SmoothEdges::measure(const Image& picture, float exposure, Quality& out) const {
  Sum jumps, bands;
  for (const Place& place : places_) {
    double l[4];
    for (size_t i = 0; i < 4; ++i) {
      const float* p = &picture.pixels[(place.first + i * place.step) * size_t(picture.channels)];
      l[i] = double(luminance({p[0], p[1], p[2]}) * exposure);
      if (!std::isfinite(l[i])) l[i] = 0;
    }
    const double before = l[1] - l[0], after = l[3] - l[2];
    const double jump = (l[2] - after / 2) - (l[1] + before / 2), band = after - before;
    jumps.add(jump * jump), bands.add(band * band);
  }
  if (places_.empty()) return;
  out.edge_jump = std::sqrt(jumps.value() / double(places_.size()));
  out.mach_band = std::sqrt(bands.value() / double(places_.size()));
}

}  // namespace aktina
