#include "aktina/radiosity/lightmap/stitch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr float kSmooth = 0.9f;      // cosine between normals of one place, as for values at vertices
constexpr float kSamePlace = 1e-3f;  // texels
constexpr double kTouched = 0.02;    // what a change of a texel weighs against one of a seam
constexpr double kUntouched = 1e-4;  // the same where no chart touches it
constexpr int kMostSteps = 100;

/// One side of an edge, from the end with the lower number.
struct EdgeSide {
  uint32_t low, high;  // numbers of its ends' places
  Vec3 normal_low, normal_high;
  Vec2 from, to;  // texels
  int page;
  auto ends() const { return std::pair(low, high); }
};

std::vector<EdgeSide> edge_sides(const LightmapLayout& layout) {
  std::vector<Point3> points;
  for (const PlacedChart& chart : layout.charts)
    for (const uint32_t t : chart.triangles)
      for (const Point3 p : layout.surfaces[chart.surface].corners[t]) points.push_back(p);
  const std::vector<uint32_t> place = weld(points);
  std::vector<EdgeSide> sides;
  sides.reserve(points.size());
  size_t corner = 0;
  for (const PlacedChart& chart : layout.charts)
    for (size_t i = 0; i < chart.triangles.size(); ++i, corner += 3)
      for (size_t k = 0; k < 3; ++k) {
        size_t a = k, b = (k + 1) % 3;
        if (place[corner + a] > place[corner + b]) std::swap(a, b);
        const auto& normals = layout.surfaces[chart.surface].normals[chart.triangles[i]];
        sides.push_back({place[corner + a], place[corner + b], normals[a], normals[b], chart.texels[i][a],
                         chart.texels[i][b], chart.page});
      }
  return sides;
}

bool is_seam(const EdgeSide& a, const EdgeSide& b) {
  if (!(dot(a.normal_low, b.normal_low) > kSmooth && dot(a.normal_high, b.normal_high) > kSmooth)) return false;
  return a.page != b.page || length(a.from - b.from) > kSamePlace || length(a.to - b.to) > kSamePlace;
}

/// Pairs of sides that must agree.
std::vector<std::pair<EdgeSide, EdgeSide>> find_seams(const LightmapLayout& layout) {
  std::vector<EdgeSide> sides = edge_sides(layout);
  std::vector<uint32_t> order(sides.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return sides[a].ends() < sides[b].ends(); });
  std::vector<std::pair<EdgeSide, EdgeSide>> seams;
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t k = i + 1; k < order.size() && sides[order[k]].ends() == sides[order[i]].ends(); ++k)
      if (is_seam(sides[order[i]], sides[order[k]])) {
        seams.emplace_back(sides[order[i]], sides[order[k]]);
        break;  // with the next one of its kind: chains hold all together
      }
  return seams;
}

/// The equations: rows are samples of seams, unknowns the texels that they read.
class Equations {
 public:
  Equations(const LightmapLayout& layout, const std::vector<std::vector<uint8_t>>& known, std::vector<Image>& pages)
      : known_(known), pages_(pages) {
    for (const auto& [a, b] : find_seams(layout)) add(a, b);
  }
  size_t samples() const { return rows_.size(); }

  SeamReport solve() {
    SeamReport report;
    report.samples = rows_.size();
    double mean = 0, before = 0, after = 0;
    for (int channel = 0; channel < 3; ++channel) {
      std::vector<double> x = read(channel);
      mean += level(x), before += gap(x);
      improve(x);
      after += gap(x);
      write(channel, x);
    }
    const double n = 3 * double(std::max<size_t>(rows_.size(), 1));
    if (mean > 0) report.before = std::sqrt(before / n) / (mean / n), report.after = std::sqrt(after / n) / (mean / n);
    return report;
  }

 private:
  struct Row {
    std::array<uint32_t, 8> texel;
    std::array<float, 8> weight;  // bilinear: those of one side, minus those of the other
  };

  void add(const EdgeSide& a, const EdgeSide& b) {
    const int steps = std::max(1, int(std::ceil(std::max(length(a.to - a.from), length(b.to - b.from)))));
    for (int i = 0; i <= steps; ++i) {
      const float t = float(i) / float(steps);
      Row row;
      read_weights(a, t, 1, 0, row), read_weights(b, t, -1, 4, row);
      rows_.push_back(row);
    }
  }
  void read_weights(const EdgeSide& side, float t, float sign, size_t slot, Row& row) {
    const Image& image = pages_[size_t(side.page)];
    const Vec2 p = side.from + t * (side.to - side.from) - 0.5f, corner = glm::floor(p), f = p - corner;
    for (int k = 0; k < 4; ++k) {
      const int x = std::clamp(int(corner.x) + k % 2, 0, image.width - 1);
      const int y = std::clamp(int(corner.y) + k / 2, 0, image.height - 1);
      row.texel[slot + size_t(k)] = unknown(side.page, x, y);
      row.weight[slot + size_t(k)] = sign * (k % 2 ? f.x : 1 - f.x) * (k / 2 ? f.y : 1 - f.y);
    }
  }
  uint32_t unknown(int page, int x, int y) {
    const uint64_t key = uint64_t(page) << 40 | uint64_t(y) << 20 | uint64_t(x);
    const auto [at, is_new] = number_.try_emplace(key, uint32_t(texels_.size()));
    if (is_new) {
      const bool touched = known_[size_t(page)][size_t(y) * size_t(pages_[size_t(page)].width) + size_t(x)];
      texels_.push_back({page, x, y});
      stiffness_.push_back(touched ? kTouched : kUntouched);
    }
    return at->second;
  }

  std::vector<double> read(int channel) const {
    std::vector<double> x;
    for (const Texel& t : texels_) x.push_back(double(pages_[size_t(t.page)].at(t.x, t.y)[channel]));
    return x;
  }
  void write(int channel, const std::vector<double>& x) {
    for (size_t i = 0; i < x.size(); ++i)
      pages_[size_t(texels_[i].page)].at(texels_[i].x, texels_[i].y)[channel] = float(std::max(0.0, x[i]));
  }

  double difference(const Row& r, const std::vector<double>& x) const {
    double sum = 0;
    for (size_t k = 0; k < 8; ++k) sum += double(r.weight[k]) * x[r.texel[k]];
    return sum;
  }
  double gap(const std::vector<double>& x) const {
    double sum = 0;
    for (const Row& r : rows_) sum += difference(r, x) * difference(r, x);
    return sum;
  }
  double level(const std::vector<double>& x) const {
    double sum = 0;
    for (const Row& r : rows_)
      for (size_t k = 0; k < 4; ++k) sum += double(r.weight[k]) * x[r.texel[k]];
    return sum;
  }

  /// y = (W' W + S) x
  std::vector<double> multiply(const std::vector<double>& x) const {
    std::vector<double> y(x.size());
    for (size_t i = 0; i < x.size(); ++i) y[i] = stiffness_[i] * x[i];
    add_transposed(x, y, 1);
    return y;
  }
  void add_transposed(const std::vector<double>& x, std::vector<double>& y, double sign) const {
    for (const Row& r : rows_) {
      const double d = sign * difference(r, x);
      for (size_t k = 0; k < 8; ++k) y[r.texel[k]] += double(r.weight[k]) * d;
    }
  }

  /// x + d, with d the least change: (W' W + S) d = -W' W x. M. Hestenes, E. Stiefel, 1952.
  void improve(std::vector<double>& x) const {
    std::vector<double> change(x.size(), 0), residual(x.size(), 0);
    add_transposed(x, residual, -1);
    std::vector<double> direction = residual;
    const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    };
    double size = product(residual, residual);
    const double enough = 1e-10 * size;
    for (int step = 0; step < kMostSteps && size > enough; ++step) {
      const std::vector<double> image = multiply(direction);
      const double along = size / product(direction, image);
      for (size_t i = 0; i < x.size(); ++i) change[i] += along * direction[i], residual[i] -= along * image[i];
      const double next = product(residual, residual);
      for (size_t i = 0; i < x.size(); ++i) direction[i] = residual[i] + next / size * direction[i];
      size = next;
    }
    for (size_t i = 0; i < x.size(); ++i) x[i] += change[i];
  }

  struct Texel {
    int page, x, y;
  };
  const std::vector<std::vector<uint8_t>>& known_;
  std::vector<Image>& pages_;
  std::unordered_map<uint64_t, uint32_t> number_;
  std::vector<Texel> texels_;
  std::vector<double> stiffness_;
  std::vector<Row> rows_;
};

}  // namespace

SeamReport stitch(const LightmapLayout& layout, const std::vector<std::vector<uint8_t>>& known,
                  std::vector<Image>& pages) {
  Equations equations(layout, known, pages);
  return equations.samples() > 0 ? equations.solve() : SeamReport{};
}

}  // namespace aktina
