#include "aktina/radiosity/lightmap/patch_locator.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/base/random.h"

namespace aktina {
namespace {

constexpr float kInside = 1e-4f;  // how far outside of a patch still counts as inside, in its size
constexpr float kMostCells = 8;   // along the largest patch

/// Coordinates (s, t) of a point of the plane z = 0 in a convex quadrilateral there, by Newton's method: at once where
/// it is a parallelogram.
Vec2 inverse_bilinear(const Vec2 (&c)[4], Vec2 p) {
  Vec2 st(0.5f);
  for (int i = 0; i < 5; ++i) {
    const Vec2 at = (c[0] * (1 - st.x) + c[1] * st.x) * (1 - st.y) + (c[3] * (1 - st.x) + c[2] * st.x) * st.y;
    const Vec2 ds = (c[1] - c[0]) * (1 - st.y) + (c[2] - c[3]) * st.y,
               dt = (c[3] - c[0]) * (1 - st.x) + (c[2] - c[1]) * st.x;
    const float det = ds.x * dt.y - ds.y * dt.x;
    const Vec2 gap = p - at;
    if (det == 0 || dot(gap, gap) == 0) break;
    st += Vec2(gap.x * dt.y - gap.y * dt.x, ds.x * gap.y - ds.y * gap.x) / det;
    st = glm::clamp(st, Vec2(-2), Vec2(3));
  }
  return st;
}

PatchPlace in_quad(const std::array<uint32_t, 4>& v, const Vec2 (&c)[4], Vec2 p) {
  const Vec2 st = glm::clamp(inverse_bilinear(c, p), Vec2(0), Vec2(1));
  return {v, {(1 - st.x) * (1 - st.y), st.x * (1 - st.y), st.x * st.y, (1 - st.x) * st.y}};
}

PatchPlace in_triangle(const std::array<uint32_t, 4>& v, const Vec2 (&c)[4], Vec2 p) {
  const Vec2 ab = c[1] - c[0], ac = c[2] - c[0], ap = p - c[0];
  const float area = ab.x * ac.y - ab.y * ac.x;
  float w[3] = {1, 0, 0};
  if (area != 0) w[1] = (ap.x * ac.y - ap.y * ac.x) / area, w[2] = (ab.x * ap.y - ab.y * ap.x) / area;
  w[0] = 1 - w[1] - w[2];
  float sum = 0;
  for (float& x : w) sum += x = std::max(x, 0.0f);
  return {v, {w[0] / sum, w[1] / sum, w[2] / sum, 0}};
}

}  // namespace

PatchLocator::PatchLocator(const PatchMesh& mesh) : mesh_(mesh) {
  for (uint32_t first = 0, end = 0; first < mesh.size(); first = end) {
    const uint32_t instance = mesh.centres[first].instance;
    while (end < mesh.size() && mesh.centres[end].instance == instance) ++end;
    grid_of_.resize(std::max(grid_of_.size(), size_t(instance) + 1));
    grid_of_[instance] = uint32_t(grids_.size());
    grids_.push_back({first, end, {}, 1, {}, {}});
  }
  parallel_for(grids_.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) build(grids_[i]);
  });
}

Bounds PatchLocator::around(uint32_t patch) const {
  Bounds box;
  for (const uint32_t v : mesh_.patches[patch]) box.add(mesh_.positions[v]);
  const Vec3 margin(kInside * box.diagonal() + 1e-6f * std::max(length(box.low), length(box.high)));
  box.low -= margin, box.high += margin;
  return box;
}

void PatchLocator::build(Grid& grid) const {
  float largest = 0;
  double area = 0;
  for (uint32_t i = grid.first; i < grid.end; ++i) {
    const Bounds box = around(i);
    grid.bounds.add(box);
    const Vec3 size = box.size();
    largest = std::max({largest, size.x, size.y, size.z});
    area += double(mesh_.areas[i]);
  }
  const auto usual = float(std::sqrt(area / double(grid.end - grid.first)));
  grid.per_metre = 1 / std::max({usual, largest / kMostCells, 1e-6f * grid.bounds.diagonal(), 1e-30f});
  std::vector<std::pair<uint32_t, uint32_t>> entries;  // bucket, patch
  grid.starts.assign(std::bit_ceil(size_t(grid.end - grid.first)) * 4 + 1, 0);
  for (uint32_t i = grid.first; i < grid.end; ++i) {
    const Bounds box = around(i);
    const glm::ivec3 low = cell_of(grid, box.low), high = cell_of(grid, box.high);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x) entries.emplace_back(bucket(grid, {x, y, z}), i);
  }
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  for (const auto& [at, patch] : entries) ++grid.starts[at + 1], grid.items.push_back(patch);
  for (size_t i = 1; i < grid.starts.size(); ++i) grid.starts[i] += grid.starts[i - 1];
}

glm::ivec3 PatchLocator::cell_of(const Grid& grid, Point3 p) const {
  return glm::ivec3((glm::clamp(p, grid.bounds.low, grid.bounds.high) - grid.bounds.low) * grid.per_metre);
}

uint32_t PatchLocator::bucket(const Grid& grid, glm::ivec3 c) const {
  const uint32_t h = hash_combine(hash_combine(hash32(uint32_t(c.x)), uint32_t(c.y)), uint32_t(c.z));
  return h & uint32_t(grid.starts.size() - 2);
}

PatchLocator::Found PatchLocator::look_at(uint32_t patch, Point3 x, Vec3 front) const {
  Found found;
  const Vec3 n = mesh_.patch_normals[patch];
  if (!(dot(n, front) > 0)) return found;
  const auto& v = mesh_.patches[patch];
  const Frame frame(n);
  const Point3 origin = mesh_.positions[v[0]];
  Vec2 c[4];
  for (size_t k = 0; k < 4; ++k) c[k] = Vec2(frame.to_local(mesh_.positions[v[k]] - origin));
  const Vec2 p(frame.to_local(x - origin));
  found.place = mesh_.is_quad(patch) ? in_quad(v, c, p) : in_triangle(v, c, p);
  Point3 at(0);
  for (size_t k = 0; k < 4; ++k) at += mesh_.positions[v[k]] * found.place.weights[k];
  found.squared_distance = squared_length(at - x);
  return found;
}

PatchPlace PatchLocator::find(uint32_t instance, Point3 x, Vec3 front, uint32_t& guess) const {
  const Grid& grid = grids_[grid_of_[instance]];
  const auto near = [&](uint32_t patch, const Found& f) {
    return f.squared_distance <= kInside * kInside * mesh_.areas[patch];
  };
  if (guess >= grid.first && guess < grid.end)
    if (const Found f = look_at(guess, x, front); near(guess, f)) return f.place;
  Found best;
  const auto consider = [&](uint32_t patch) {
    const Found f = look_at(patch, x, front);
    if (f.squared_distance < best.squared_distance) best = f, guess = patch;
  };
  const uint32_t at = bucket(grid, cell_of(grid, x));
  for (uint32_t i = grid.starts[at]; i < grid.starts[at + 1]; ++i) consider(grid.items[i]);
  if (!(best.squared_distance < kInfinity))
    for (uint32_t patch = grid.first; patch < grid.end; ++patch) consider(patch);
  if (!(best.squared_distance < kInfinity)) best.place = {mesh_.patches[grid.first], {1, 0, 0, 0}};
  return best.place;
}

}  // namespace aktina
