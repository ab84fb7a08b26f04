#include "aktina/radiosity/solver/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <numeric>

#include "aktina/base/parallel.h"
#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr float kSmooth = 0.9f;           // cosine between the normals of vertices in one place that count as one
constexpr double kClosedFan = 1.6 * kPi;  // rad: angles about a vertex within a surface add up to about 2 pi
constexpr float kBorderReach = 0.5f;

/// Items of each group, one list after the other.
struct Lists {
  std::vector<uint32_t> first, items;
  std::span<const uint32_t> operator[](size_t i) const { return {items.data() + first[i], first[i + 1] - first[i]}; }
};

}  // namespace

struct Reconstruction::Builder {
  const PatchMesh& mesh;
  Reconstruction& out;
  size_t groups = 0;
  std::vector<Vec3> normals;    // of each group, the sum of its vertices'
  std::vector<Point3> places;   // of each group
  std::vector<Point3> centres;  // of each patch
  Lists around;                 // patches of each group

  void run() {
    make_groups();
    centres.reserve(mesh.size());
    out.stencils_.reserve(groups), out.patches_.reserve(4 * groups), out.weights_.reserve(4 * groups);
    for (size_t i = 0; i < mesh.size(); ++i) {
      Point3 sum(0);
      const size_t n = corners(uint32_t(i));
      for (size_t k = 0; k < n; ++k) sum += mesh.positions[mesh.patches[i][k]];
      centres.push_back(sum * (1 / float(n)));
    }
    collect_patches();
    std::vector<uint32_t> ring;
    for (uint32_t g = 0; g < groups; ++g) {
      const bool border = angle_about(g) < kClosedFan;
      ring.assign(around[g].begin(), around[g].end());
      if (border) widen(ring);
      add_stencil(g, ring, border);
    }
  }

  size_t corners(uint32_t patch) const { return mesh.is_quad(patch) ? 4 : 3; }
  uint32_t group(uint32_t patch, size_t corner) const { return out.group_[mesh.patches[patch][corner]]; }

  /// Vertices in one place with nearly the same normal are one.
  void make_groups() {
    constexpr uint32_t kNone = 0xffffffff;
    const std::vector<uint32_t> same = weld(mesh.positions);
    const std::vector<uint8_t> two_sided = sidedness();
    std::vector<uint32_t> head(mesh.positions.size(), kNone), next;
    out.group_.resize(mesh.positions.size());
    std::vector<uint8_t> kind;
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      uint32_t g = head[same[v]];
      while (g != kNone && (dot(normals[g], mesh.normals[v]) < kSmooth || kind[g] != two_sided[v])) g = next[g];
      if (g == kNone) {
        g = uint32_t(normals.size());
        normals.push_back(mesh.normals[v]), places.push_back(mesh.positions[v]);
        kind.push_back(two_sided[v]), next.push_back(head[same[v]]);
        head[same[v]] = g;
      }
      out.group_[v] = g;
    }
    groups = normals.size();
  }
  std::vector<uint8_t> sidedness() const {
    std::vector<uint8_t> two_sided(mesh.positions.size(), 0);
    for (size_t i = 0; i < mesh.size(); ++i)
      for (const uint32_t v : mesh.patches[i]) two_sided[v] = mesh.two_sided[i];
    return two_sided;
  }

  void collect_patches() {
    around.first.assign(groups + 1, 0);
    for (uint32_t i = 0; i < mesh.size(); ++i)
      for (size_t k = 0; k < corners(i); ++k) ++around.first[group(i, k) + 1];
    std::partial_sum(around.first.begin(), around.first.end(), around.first.begin());
    around.items.resize(around.first.back());
    std::vector<uint32_t> cursor(around.first.begin(), around.first.end() - 1);
    for (uint32_t i = 0; i < mesh.size(); ++i)
      for (size_t k = 0; k < corners(i); ++k) around.items[cursor[group(i, k)]++] = i;
  }

  double angle_at(uint32_t patch, uint32_t g) const {
    const size_t n = corners(patch);
    for (size_t k = 0; k < n; ++k) {
      if (group(patch, k) != g) continue;
      const auto& c = mesh.patches[patch];
      const Vec3 a = mesh.positions[c[(k + 1) % n]] - mesh.positions[c[k]];
      const Vec3 b = mesh.positions[c[(k + n - 1) % n]] - mesh.positions[c[k]];
      return std::atan2(double(length(cross(a, b))), double(dot(a, b)));
    }
    return 0;
  }
  double angle_about(uint32_t g) const {
    double sum = 0;
    for (const uint32_t patch : around[g]) sum += angle_at(patch, g);
    return sum;
  }

  /// Adds the patches that touch those of the list across a smooth surface.
  void widen(std::vector<uint32_t>& ring) const {
    const size_t inner = ring.size();
    for (size_t i = 0; i < inner; ++i)
      for (size_t k = 0; k < corners(ring[i]); ++k)
        for (const uint32_t more : around[group(ring[i], k)]) ring.push_back(more);
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  }

  /// Weights of the value at the vertex in the weighted least-squares plane through the patches' values at their
  /// centres: first row of (X' W X)^-1 X' W. A weighted mean where the centres do not span a plane.
  void add_stencil(uint32_t g, const std::vector<uint32_t>& ring, bool border) {
    const Frame frame(normalize_or(normals[g], {0, 1, 0}));
    double size = 0;
    for (const uint32_t patch : ring) size += double(squared_length(centres[patch] - places[g]));
    const double scale = 1 / std::sqrt(std::max(size / double(std::max<size_t>(ring.size(), 1)), 1e-60));
    glm::dmat3 moments(0);
    std::vector<std::pair<double, Vec3d>> rows;
    for (const uint32_t patch : ring) {
      const Vec3 d = frame.to_local(centres[patch] - places[g]);
      const Vec3d x(1, double(d.x) * scale, double(d.y) * scale);
      const double angle = angle_at(patch, g);
      const double weight = (border ? 0.2 * kPi + angle : angle) / (0.1 + x.y * x.y + x.z * x.z);
      moments += weight * glm::outerProduct(x, x);
      rows.emplace_back(weight, x);
    }
    const double total = moments[0][0];
    const bool plane = ring.size() >= 3 && glm::determinant(moments) > 1e-4 * total * total * total;
    const Vec3d first = plane ? glm::inverse(moments)[0] : Vec3d(total > 0 ? 1 / total : 0, 0, 0);
    out.stencils_.push_back({uint32_t(out.patches_.size()), uint32_t(ring.size()), border ? kBorderReach : 0});
    for (size_t i = 0; i < ring.size(); ++i) {
      out.patches_.push_back(ring[i]);
      out.weights_.push_back(float(rows[i].first * dot(first, rows[i].second)));
    }
  }
};

Reconstruction::Reconstruction(const PatchMesh& mesh) { Builder{mesh, *this, 0, {}, {}, {}, {}}.run(); }

std::vector<Irradiance> Reconstruction::at_vertices(std::span<const Irradiance> values) const {
  std::vector<Irradiance> of_group(stencils_.size()), out(group_.size());
  parallel_for(stencils_.size(), 1024, [&](size_t begin, size_t end) {
    for (size_t g = begin; g < end; ++g) {
      const Stencil s = stencils_[g];
      if (s.count == 0) continue;
      Rgb low = values[patches_[s.first]].v, high = low;
      double sum[3] = {0, 0, 0};
      for (uint32_t i = s.first; i < s.first + s.count; ++i)
        for (int c = 0; c < 3; ++c) {
          const float value = values[patches_[i]].v[c];
          sum[c] += double(weights_[i]) * double(value);
          low[c] = std::min(low[c], value), high[c] = std::max(high[c], value);
        }
      for (int c = 0; c < 3; ++c) {
        const float beyond = s.reach * (high[c] - low[c]);
        of_group[g].v[c] = std::clamp(float(sum[c]), std::max(0.0f, low[c] - beyond), high[c] + beyond);
      }
    }
  });
  for (size_t v = 0; v < out.size(); ++v) out[v] = of_group[group_[v]];
  return out;
}

void reconstruct_vertices(Solution& s) {
  const PatchMesh& mesh = s.mesh;
  const Reconstruction reconstruction(mesh);
  s.vertex_irradiances = reconstruction.at_vertices(s.irradiances);
  s.vertex_direct_irradiances = reconstruction.at_vertices(s.direct_irradiances);
  if (std::find(mesh.two_sided.begin(), mesh.two_sided.end(), 1) != mesh.two_sided.end()) {
    s.vertex_back_irradiances = reconstruction.at_vertices(s.back_irradiances);
    s.vertex_back_direct_irradiances = reconstruction.at_vertices(s.back_direct_irradiances);
  } else {
    s.vertex_back_irradiances.assign(mesh.positions.size(), Irradiance());
    s.vertex_back_direct_irradiances = s.vertex_back_irradiances;
  }
  // Radiosity jumps where the material does: each vertex has the mean reflectance of its own mesh's patches.
  const size_t n = mesh.positions.size();
  std::vector<Rgb> reflectance(n), emission(n);
  std::vector<float> area(n, 0);
  for (size_t i = 0; i < mesh.size(); ++i)
    for (size_t k = 0; k < (mesh.is_quad(i) ? 4U : 3U); ++k) {
      const uint32_t v = mesh.patches[i][k];
      reflectance[v] += mesh.reflectances[i] * mesh.areas[i], emission[v] += mesh.emissions[i].v * mesh.areas[i];
      area[v] += mesh.areas[i];
    }
  s.vertex_radiosities.assign(n, Radiosity());
  for (size_t v = 0; v < n; ++v)
    if (area[v] > 0)
      s.vertex_radiosities[v] = Radiosity((emission[v] + reflectance[v] * s.vertex_irradiances[v].v) / area[v]);
}

}  // namespace aktina
