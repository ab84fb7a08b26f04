// Where triangles of a smooth surface meet in a picture, and what happens to the light there.
#include <array>
#include <cmath>

#include "aktina/base/statistics.h"
#include "aktina/render/study/quality.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr size_t kSide = 3;  // pixels on either side of an edge

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

/// Value and derivative away from the edge, there, of the parabola through three pixels, the first half a pixel off.
struct AtEdge {
  double value, slope;
};
AtEdge at_edge(double near, double middle, double far) {
  return {(15 * near - 10 * middle + 3 * far) / 8, 3 * middle - 2 * near - far};
}

}  // namespace

SmoothEdges::SmoothEdges(const Scene& scene, const Camera& camera, int width, int height) {
  const ItemRasterizer rasterizer(scene);
  ItemBuffer items;
  rasterizer.draw(camera, width, height, items);
  const std::vector<Corners> corners = corners_of(scene);
  for (const uint32_t item : items.item) covered_ += item != ItemBuffer::kNothing;

  const auto look = [&](size_t first, size_t step) {
    const uint32_t a = items.item[first], b = items.item[first + kSide * step];
    if (a == b || a == ItemBuffer::kNothing || b == ItemBuffer::kNothing) return;
    for (size_t i = 1; i < kSide; ++i)
      if (items.item[first + i * step] != a || items.item[first + (kSide + i) * step] != b) return;
    if (meet_smoothly(corners[a], corners[b])) places_.push_back({first, step});
  };
  const auto w = size_t(width), h = size_t(height);
  for (size_t y = 0; y < h; ++y)
    for (size_t x = 0; x < w; ++x) {
      if (x + 2 * kSide <= w) look(y * w + x, 1);
      if (y + 2 * kSide <= h) look(y * w + x, w);
    }
}

void SmoothEdges::measure(const Image& picture, float exposure, Quality& out) const {
  Sum jumps, bands;
  for (const Place& place : places_) {
    const auto luminance_at = [&](size_t i) {
      const float* p = &picture.pixels[(place.first + i * place.step) * size_t(picture.channels)];
      const double l = double(luminance({p[0], p[1], p[2]}) * exposure);
      return std::isfinite(l) ? l : 0;
    };
    const AtEdge left = at_edge(luminance_at(2), luminance_at(1), luminance_at(0));
    const AtEdge right = at_edge(luminance_at(3), luminance_at(4), luminance_at(5));
    const double jump = right.value - left.value, band = right.slope + left.slope;
    jumps.add(jump * jump), bands.add(band * band);
  }
  if (places_.empty()) return;
  out.edge_jump = std::sqrt(jumps.value() / double(places_.size()));
  out.mach_band = std::sqrt(bands.value() / double(places_.size()));
}

}  // namespace aktina
