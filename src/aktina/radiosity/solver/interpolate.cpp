#include "aktina/radiosity/solver/interpolate.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <unordered_map>

#include "aktina/base/parallel.h"

namespace aktina {
namespace {

constexpr double kReach = 1.8;      // of a patch's size: neighbours farther away than this weigh nothing
constexpr double kListReach = 2.6;  // from the middle of a patch, so that all of it finds its neighbours
constexpr size_t kMostNeighbours = 32;
constexpr float kLeastCosine = 0.7f;
constexpr float kLift = 0.15f;    // of a patch's size: the height at which neighbours must see each other
constexpr double kBeyond = 0.25;  // of the neighbours' range

/// Middles of patches in cells of a grid.
class Grid {
 public:
  struct Item {
    Point3 centre;
    uint32_t patch;
  };
  Grid(const CoarsePatches& patches, double cell) : cell_(float(cell)) {
    for (uint32_t i = 0; i < patches.size(); ++i)
      cells_[key(cell_of(patches.centre(i)))].push_back({patches.centre(i), i});
  }
  template <class Body>
  void around(Point3 p, double radius, const Body& body) const {
    const glm::ivec3 low = cell_of(p - float(radius)), high = cell_of(p + float(radius));
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
        for (int x = low.x; x <= high.x; ++x)
          if (const auto at = cells_.find(key({x, y, z})); at != cells_.end())
            for (const Item& item : at->second) body(item);
  }

 private:
  glm::ivec3 cell_of(Point3 p) const { return glm::ivec3(glm::floor(p / cell_)); }
  static uint64_t key(glm::ivec3 c) {
    return (uint64_t(uint32_t(c.x)) & 0x1fffff) << 42 | (uint64_t(uint32_t(c.y)) & 0x1fffff) << 21 |
           (uint64_t(uint32_t(c.z)) & 0x1fffff);
  }
  float cell_;
  std::unordered_map<uint64_t, std::vector<Item>> cells_;
};

}  // namespace

CoarseInterpolation::CoarseInterpolation(const CoarsePatches& patches, const Sides& sides, const Visibility& visibility)
    : patches_(patches), sides_(sides), visibility_(visibility) {
  find_neighbours();
}

double CoarseInterpolation::size(size_t patch) const { return patches_.extent(patch); }

void CoarseInterpolation::find_neighbours() {
  double largest = 0;
  for (size_t i = 0; i < patches_.size(); ++i) largest = std::max(largest, size(i));
  const Grid grid(patches_, largest);
  std::vector<std::vector<uint32_t>> lists(patches_.size());
  parallel_for(patches_.size(), 64, [&](size_t begin, size_t end) {
    std::vector<std::pair<float, uint32_t>> found;
    for (size_t i = begin; i < end; ++i) {
      found.clear();
      const Point3 x = patches_.centre(i);
      const Vec3 n = patches_.normal(i);
      const auto reach = float(kListReach * size(i)), lift = kLift * float(size(i));
      grid.around(x, double(reach), [&](const Grid::Item& item) {
        const float squared = squared_length(item.centre - x);
        const uint32_t j = item.patch;
        if (squared < reach * reach && dot(n, patches_.normal(j)) > kLeastCosine &&
            patches_.buried(i) == patches_.buried(j))
          found.emplace_back(j == i ? -1 : squared, j);
      });
      const size_t kept = std::min(found.size(), kMostNeighbours);
      std::partial_sort(found.begin(), found.begin() + std::ptrdiff_t(kept), found.end());
      found.resize(kept);
      for (size_t first = 0; first < kept; first += kPacket) {
        const size_t count = std::min(kept - first, size_t(kPacket));
        RayPacket rays{};
        float shares[kPacket];
        for (size_t k = 0; k < count; ++k) {
          const uint32_t j = found[first + k].second;
          const Point3 from = x + (lift + visibility_.offset()) * n,
                       to = patches_.centre(j) + (lift + visibility_.offset()) * patches_.normal(j);
          rays.set(int(k), {from, to - from + 1e-6f * n, 0, 1});
        }
        visibility_.passing(rays, (1U << count) - 1, Coherence::coherent, shares);
        for (size_t k = 0; k < count; ++k)
          if (found[first + k].second == i || shares[k] > 0) lists[i].push_back(found[first + k].second);
      }
    }
  });
  first_.push_back(0);
  for (const auto& list : lists) {
    neighbours_.insert(neighbours_.end(), list.begin(), list.end());
    first_.push_back(uint32_t(neighbours_.size()));
  }
}

/// Weighted least squares: value at the side's middle of the plane through the neighbours' values.
Rgb CoarseInterpolation::at(size_t side, std::span<const double> coarse) const {
  const size_t own = patches_.patch_of_side(side);
  const Frame frame(sides_.normal(side));
  const double reach = kReach * size(own);
  glm::dmat3 moments(0);
  Vec3d sums[3] = {Vec3d(0), Vec3d(0), Vec3d(0)};
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {0, 0, 0};
  for (uint32_t k = first_[own]; k < first_[own + 1]; ++k) {
    const uint32_t j = neighbours_[k];
    const Vec3 d = frame.to_local(patches_.centre(j) - sides_.centre(side));
    const double far = double(squared_length(d)) / (reach * reach);
    const double facing =
        double(dot(sides_.normal(side), patches_.normal(j)) - kLeastCosine) / (1 - double(kLeastCosine));
    if (!(far < 1 && facing > 0)) continue;
    const double weight = patches_.area(j) * (1 - far) * (1 - far) * facing;
    const Vec3d x(1, double(d.x) / reach, double(d.y) / reach);
    moments += weight * glm::outerProduct(x, x);
    for (size_t b = 0; b < 3; ++b) {
      const double value = coarse[j * 3 + b];
      sums[b] += weight * value * x;
      low[b] = std::min(low[b], value), high[b] = std::max(high[b], value);
    }
  }
  Rgb out;
  const double total = moments[0][0];
  const bool plane = glm::determinant(moments) > 1e-4 * total * total * total;
  const Vec3d row = plane ? glm::inverse(moments)[0] : Vec3d(total > 0 ? 1 / total : 0, 0, 0);
  for (size_t b = 0; b < 3; ++b) {
    const double value = total > 0 ? dot(row, sums[b]) : coarse[own * 3 + b];
    const double beyond = total > 0 ? kBeyond * (high[b] - low[b]) : 1e300;
    out[int(b)] = float(std::clamp(value, std::max(0.0, low[b] - beyond), high[b] + beyond));
    if (!(total > 0)) out[int(b)] = float(value);
  }
  return out;
}

void CoarseInterpolation::add(std::span<const double> coarse, const std::vector<float>& open,
                              std::vector<Rgb>& fine) const {
  parallel_for(sides_.size(), 1024, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s)
      if (open[s] > 0 || patches_.buried(patches_.patch_of_side(s))) fine[s] += at(s, coarse);
  });
}

}  // namespace aktina
