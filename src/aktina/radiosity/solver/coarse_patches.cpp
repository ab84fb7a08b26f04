#include "aktina/radiosity/solver/coarse_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr int kFacets = 3;             // squares along a side of the cube of directions
constexpr float kSightHeight = 0.15f;  // of the distance, at which members must see each other
constexpr float kShift = 0.3819f;      // of a cell: planes at round coordinates do not lie between cells

/// Which square of a cube about the origin a direction goes through.
uint32_t facet_of(Vec3 n) {
  const Vec3 a = glm::abs(n);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto slot = [&](int k) { return std::clamp(int((n[k] / a[axis] + 1) * 0.5f * kFacets), 0, kFacets - 1); };
  return uint32_t(((axis * 2 + (n[axis] < 0)) * kFacets + slot(u)) * kFacets + slot(v));
}

/// Sets that are joined step by step; the lowest member names its set.
class Sets {
 public:
  explicit Sets(size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  uint32_t find(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(uint32_t a, uint32_t b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parent_;
};

Point3 middle_of(const std::array<Point3, 4>& c) {
  return c[2] != c[3] ? 0.25f * (c[0] + c[1] + c[2] + c[3]) : (c[0] + c[1] + c[2]) * (1.0f / 3);
}

bool all_buried(const Sides::Shooter& shooter, const std::vector<uint8_t>& buried) {
  const auto begin = buried.begin() + shooter.range.first;
  return std::all_of(begin, begin + shooter.range.count, [](uint8_t b) { return b != 0; });
}

/// By shooter: its set, or the first one of those that are hidden from the set's first one that is not buried.
std::vector<uint32_t> part_by_sight(std::span<const Sides::Shooter> shooters, const std::vector<uint8_t>& buried,
                                    Sets& sets, const Visibility& visibility) {
  constexpr uint32_t kNone = 0xffffffff;
  std::vector<uint32_t> from(shooters.size(), kNone), part(shooters.size()), hidden(shooters.size(), kNone);
  std::vector<float> seen(shooters.size(), 1);
  VisibilityQueue queue(visibility, Coherence::coherent, seen.data());
  for (uint32_t i = 0; i < shooters.size(); ++i) {
    part[i] = sets.find(i);
    uint32_t& first = from[part[i]];
    if (all_buried(shooters[i], buried)) continue;
    if (first == kNone) first = i;
    if (first == i) continue;
    seen[i] = 0;
    const Point3 a = middle_of(shooters[first].corners), b = middle_of(shooters[i].corners);
    const float lift = kSightHeight * length(b - a) + visibility.offset();
    const Point3 eye = a + lift * shooters[first].normal, to = b + lift * shooters[i].normal;
    queue.add({eye, to - eye, 0, 1}, i);
  }
  queue.flush();
  for (uint32_t i = 0; i < shooters.size(); ++i) {
    if (seen[i] > 0) continue;
    uint32_t& other = hidden[part[i]];
    if (other == kNone) other = i;
    part[i] = other;
  }
  return part;
}

double longest_edge(const std::array<Point3, 4>& c) {
  float longest = 0;
  for (size_t k = 0; k < 4; ++k) longest = std::max(longest, length(c[k] - c[(k + 1) % 4]));
  return double(longest);
}

}  // namespace

CoarsePatches::CoarsePatches(const Sides& sides, double size, const std::vector<uint8_t>& buried,
                             const Visibility& visibility)
    : all_(sides) {
  group(size, buried, visibility);
  list_sides(buried);
}

void CoarsePatches::group(double size, const std::vector<uint8_t>& buried, const Visibility& visibility) {
  const auto& shooters = all_.shooters();
  Bounds box;
  for (const Point3 p : all_.mesh().positions) box.add(p);
  std::vector<uint64_t> keys;
  std::vector<Point3> corners;
  for (const Sides::Shooter& s : shooters) {
    const glm::ivec3 cell((middle_of(s.corners) - box.low) / float(size) + kShift);
    const uint32_t first = s.range.first;
    uint64_t key = all_.mesh().centres[all_.patch(first)].instance;
    for (const uint64_t part : {uint64_t(all_.is_back(first)), uint64_t(facet_of(s.normal)), uint64_t(cell.x),
                                uint64_t(cell.y), uint64_t(cell.z)})
      key = key * 0x9e3779b97f4a7c15ULL + part + (key >> 29);
    keys.push_back(key);
    corners.insert(corners.end(), s.corners.begin(), s.corners.end());
  }
  // Shooters of one key that share a corner belong together. Not those that are large enough: what stands on the line
  // between them may keep their light apart.
  const std::vector<uint32_t> same = weld(corners);
  std::unordered_map<uint64_t, uint32_t> seen;
  Sets sets(shooters.size());
  for (uint32_t i = 0; i < shooters.size(); ++i)
    for (size_t k = 0; k < 4 && longest_edge(shooters[i].corners) <= 0.5 * size; ++k) {
      const auto [at, is_new] = seen.try_emplace(keys[i] ^ (uint64_t(same[4 * i + k]) * 0xff51afd7ed558ccdULL), i);
      if (!is_new && keys[at->second] == keys[i]) sets.join(at->second, i);
    }
  const std::vector<uint32_t> of_set = part_by_sight(shooters, buried, sets, visibility);
  constexpr uint32_t kNone = 0xffffffff;
  std::vector<uint32_t> number(shooters.size(), kNone);
  uint32_t count = 0;
  of_shooter_.resize(shooters.size());
  for (uint32_t i = 0; i < shooters.size(); ++i) {
    uint32_t& n = number[of_set[i]];
    if (n == kNone) n = count++;
    of_shooter_[i] = n;
  }
  areas_.assign(count, 0);
  first_shooter_.assign(count + 1, 0);
  for (const uint32_t patch : of_shooter_) ++first_shooter_[patch + 1];
  std::partial_sum(first_shooter_.begin(), first_shooter_.end(), first_shooter_.begin());
  std::vector<uint32_t> cursor(first_shooter_.begin(), first_shooter_.end() - 1);
  shooters_.resize(shooters.size());
  for (uint32_t i = 0; i < shooters.size(); ++i) shooters_[cursor[of_shooter_[i]]++] = i;
}

void CoarsePatches::list_sides(const std::vector<uint8_t>& buried) {
  of_side_.resize(all_.size());
  middles_.resize(size()), normals_.resize(size()), buried_.assign(size(), 0);
  sides_.reserve(all_.size()), sums_.reserve(all_.size());
  for (uint32_t patch = 0; patch < size(); ++patch) {
    first_side_.push_back(uint32_t(sides_.size()));
    bool open = false;
    const auto each_side = [&](const auto& body) {
      for (const uint32_t shooter : shooters(patch)) {
        const auto range = all_.shooters()[shooter].range;
        for (uint32_t s = range.first; s < range.first + range.count; ++s) body(s);
      }
    };
    each_side([&](uint32_t s) { of_side_[s] = patch, open = open || !buried[s]; });
    buried_[patch] = !open;
    each_side([&](uint32_t s) {
      if (open && buried[s]) return;
      areas_[patch] += double(all_.mesh().areas[all_.patch(s)]);
      sides_.push_back(s), sums_.push_back(float(areas_[patch]));
    });
  }
  first_side_.push_back(uint32_t(sides_.size()));
  for (uint32_t patch = 0; patch < size(); ++patch) find_middle(patch);
}

void CoarsePatches::find_middle(size_t patch) {
  Vec3d centre(0), normal(0);
  for (const uint32_t s : sides(patch)) {
    const double area = double(all_.mesh().areas[all_.patch(s)]);
    centre += area * Vec3d(all_.centre(s)), normal += area * Vec3d(all_.normal(s));
  }
  centre /= areas_[patch];
  uint32_t nearest = sides(patch)[0];
  for (const uint32_t s : sides(patch))
    if (squared_length(Vec3d(all_.centre(s)) - centre) < squared_length(Vec3d(all_.centre(nearest)) - centre))
      nearest = s;
  middles_[patch] = nearest;
  normals_[patch] = normalize_or(Vec3(normal), all_.normal(nearest));
}

CoarsePatches::Place CoarsePatches::place(size_t patch, Vec2 u) const {
  const auto begin = sums_.begin() + first_side_[patch], end = sums_.begin() + first_side_[patch + 1];
  const float target = u.x * *(end - 1);
  const auto at = std::min(std::upper_bound(begin, end, target), end - 1);
  const float before = at == begin ? 0 : *(at - 1);
  const float within = std::clamp((target - before) / (*at - before), 0.0f, 1.0f);
  const uint32_t side = sides_[size_t(at - sums_.begin())];
  return {side, all_.point(side, {within, u.y})};
}

std::vector<double> CoarsePatches::means(std::span<const double> values, size_t bands) const {
  std::vector<double> out(size() * bands, 0);
  for (size_t patch = 0; patch < size(); ++patch) {
    for (const uint32_t s : sides(patch))
      for (size_t b = 0; b < bands; ++b)
        out[patch * bands + b] += double(all_.mesh().areas[all_.patch(s)]) * values[s * bands + b];
    for (size_t b = 0; b < bands; ++b) out[patch * bands + b] /= areas_[patch];
  }
  return out;
}

}  // namespace aktina
