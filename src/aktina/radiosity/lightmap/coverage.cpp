#include "aktina/radiosity/lightmap/coverage.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr uint32_t kNobody = 0xffffffff;
constexpr int kBand = 32;  // rows

struct Owner {
  float squared_distance = kInfinity;
  uint32_t chart = kNobody, triangle = 0;
  float u = 0, v = 0;
};

/// The texels of a page in a band of rows.
class Band {
 public:
  Band(const LightmapLayout& layout, int page, int first, int end, std::vector<Owner>& owners)
      : layout_(layout),
        page_(page),
        width_(layout.pages[size_t(page)].width),
        first_(first),
        end_(end),
        owners_(owners) {}

  void run() {
    for (uint32_t c = 0; c < layout_.charts.size(); ++c) {
      const PlacedChart& chart = layout_.charts[c];
      if (chart.page != page_ || chart.y >= end_ || chart.y + chart.height <= first_) continue;
      for (uint32_t t = 0; t < chart.texels.size(); ++t) add(chart.texels[t], c, t);
    }
  }

 private:
  void add(const FlatTriangle& t, uint32_t chart, uint32_t triangle) {
    const Vec2 low = glm::min(t[0], glm::min(t[1], t[2])), high = glm::max(t[0], glm::max(t[1], t[2]));
    const int x0 = std::max(0, int(std::floor(low.x))), x1 = std::min(width_ - 1, int(std::floor(high.x)));
    const int y0 = std::max(first_, int(std::floor(low.y))), y1 = std::min(end_ - 1, int(std::floor(high.y)));
    if (x0 > x1 || y0 > y1) return;
    set_edges(t);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const Vec2 middle(float(x) + 0.5f, float(y) + 0.5f);
        if (!touches(middle)) continue;
        const Vec2 at = nearest_on_triangle(t, middle);
        const Vec2 gap = t[0] + at.x * (t[1] - t[0]) + at.y * (t[2] - t[0]) - middle;
        Owner& owner = owners_[size_t(y) * size_t(width_) + size_t(x)];
        if (dot(gap, gap) < owner.squared_distance) owner = {dot(gap, gap), chart, triangle, at.x, at.y};
      }
  }

  /// Distances of the triangle's edges to where a texel's square would just touch them.
  void set_edges(const FlatTriangle& t) {
    const float turn = twice_area(t) < 0 ? -1.0f : 1.0f;
    for (size_t k = 0; k < 3; ++k) {
      const Vec2 along = t[(k + 1) % 3] - t[k];
      inward_[k] = Vec2(-along.y, along.x) * turn;
      reach_[k] = dot(t[k], inward_[k]) - 0.5f * (std::fabs(along.x) + std::fabs(along.y)) * 1.00001f;
    }
  }
  bool touches(Vec2 middle) const {
    return dot(middle, inward_[0]) >= reach_[0] && dot(middle, inward_[1]) >= reach_[1] &&
           dot(middle, inward_[2]) >= reach_[2];
  }

  const LightmapLayout& layout_;
  int page_, width_, first_, end_;
  std::vector<Owner>& owners_;
  Vec2 inward_[3];
  float reach_[3];
};

}  // namespace

Vec2 nearest_on_triangle(const FlatTriangle& t, Vec2 p) {
  const Vec2 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const float area = twice_area(t);
  if (area != 0) {
    const float u = (ap.x * ac.y - ap.y * ac.x) / area, v = (ab.x * ap.y - ab.y * ap.x) / area;
    if (u >= 0 && v >= 0 && u + v <= 1) return {u, v};
  }
  const Vec2 corner[3] = {{0, 0}, {1, 0}, {0, 1}};
  Vec2 best(0);
  float least = kInfinity;
  for (size_t k = 0; k < 3; ++k) {
    const size_t next = (k + 1) % 3;
    const Vec2 edge = t[next] - t[k];
    const float squared = dot(edge, edge);
    const float s = squared > 0 ? std::clamp(dot(p - t[k], edge) / squared, 0.0f, 1.0f) : 0;
    const Vec2 gap = t[k] + s * edge - p;
    if (!(dot(gap, gap) < least)) continue;
    least = dot(gap, gap), best = corner[k] + s * (corner[next] - corner[k]);
  }
  return best;
}

std::vector<LightmapTexel> covered_texels(const LightmapLayout& layout) {
  std::vector<LightmapTexel> texels;
  for (int page = 0; page < int(layout.pages.size()); ++page) {
    const auto [width, height] = layout.pages[size_t(page)];
    std::vector<Owner> owners(size_t(width) * size_t(height));
    parallel_for(size_t((height + kBand - 1) / kBand), 1, [&, rows = height](size_t begin, size_t end) {
      for (size_t b = begin; b < end; ++b)
        Band(layout, page, int(b) * kBand, std::min(rows, int(b + 1) * kBand), owners).run();
    });
    for (size_t i = 0; i < owners.size(); ++i)
      if (const Owner& o = owners[i]; o.chart != kNobody)
        texels.push_back({o.chart, o.triangle, uint32_t(i % size_t(width)), uint32_t(i / size_t(width)), o.u, o.v});
  }
  return texels;
}

}  // namespace aktina
