#include "aktina/radiosity/solver/shooter_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "aktina/scene/weld.h"

namespace aktina {
namespace {

constexpr uint32_t kNone = 0xffffffff;
constexpr int kFacets = 3;             // squares along a side of the cube of directions
constexpr float kSightHeight = 0.15f;  // of the distance, at which members must see each other
constexpr float kThingHeight = 0.25f;  // of a small thing's size: more is not needed
constexpr float kShift = 0.3819f;      // of a cell: planes at round coordinates do not lie between cells
constexpr float kSmall = 0.25f;        // of a cell: things that join others
constexpr int kMostRounds = 64;

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

float longest_edge(const std::array<Point3, 4>& c) {
  float longest = 0;
  for (size_t k = 0; k < 4; ++k) longest = std::max(longest, length(c[k] - c[(k + 1) % 4]));
  return longest;
}

class Grouping {
 public:
  Grouping(const Sides& sides, float size, const std::vector<float>& open, const Visibility& visibility)
      : sides_(sides),
        shooters_(sides.shooters()),
        size_(size),
        visibility_(visibility),
        sets_(shooters_.size()),
        height_(shooters_.size(), kInfinity) {
    Bounds box;
    for (const Point3 p : sides.mesh().positions) box.add(p);
    origin_ = box.low;
    for (const Sides::Shooter& s : shooters_) {
      const auto begin = open.begin() + s.range.first;
      buried_.push_back(std::all_of(begin, begin + s.range.count, [](float share) { return share == 0; }));
    }
  }

  ShooterGroups run() {
    join_neighbours();
    std::vector<uint32_t> things;
    for (uint32_t i = 0; i < shooters_.size(); ++i) things.push_back(sets_.find(i));
    join_small(things);
    ShooterGroups groups{part_by_sight(), {}};
    for (uint32_t i = 0; i < shooters_.size(); ++i) groups.scattered.push_back(things[i] != things[groups.first[i]]);
    return groups;
  }

 private:
  /// Of what may belong together: facing one way in one cell.
  uint64_t key(const Sides::Shooter& s, Point3 middle, uint64_t instance) const {
    const glm::ivec3 cell((middle - origin_) / size_ + kShift);
    uint64_t key = instance;
    for (const uint64_t part : {uint64_t(sides_.is_back(s.range.first)), uint64_t(facet_of(s.normal)), uint64_t(cell.x),
                                uint64_t(cell.y), uint64_t(cell.z)})
      key = key * 0x9e3779b97f4a7c15ULL + part + (key >> 29);
    return key;
  }

  /// Shooters of one key that share a corner. Not those that are large enough: what stands on the line between them may
  /// keep their light apart.
  void join_neighbours() {
    std::vector<Point3> corners;
    for (const Sides::Shooter& s : shooters_) corners.insert(corners.end(), s.corners.begin(), s.corners.end());
    const std::vector<uint32_t> same = weld(corners);
    struct Corner {
      uint64_t key;
      uint32_t vertex, shooter;
      bool operator<(const Corner& other) const {
        return key != other.key         ? key < other.key
               : vertex != other.vertex ? vertex < other.vertex
                                        : shooter < other.shooter;
      }
    };
    std::vector<Corner> all;
    for (uint32_t i = 0; i < shooters_.size(); ++i) {
      const Sides::Shooter& s = shooters_[i];
      if (longest_edge(s.corners) > 0.5f * size_) continue;
      const uint64_t own = key(s, middle_of(s.corners), sides_.mesh().centres[sides_.patch(s.range.first)].instance);
      for (size_t k = 0; k < 4; ++k) all.push_back({own, same[4 * i + k], i});
    }
    std::sort(all.begin(), all.end());
    for (size_t k = 1; k < all.size(); ++k)
      if (all[k].key == all[k - 1].key && all[k].vertex == all[k - 1].vertex)
        sets_.join(all[k - 1].shooter, all[k].shooter);
  }

  /// @param things  by shooter: its set
  void join_small(const std::vector<uint32_t>& things) {
    std::vector<Bounds> bounds(shooters_.size());
    for (uint32_t i = 0; i < shooters_.size(); ++i)
      for (const Point3 p : shooters_[i].corners) bounds[things[i]].add(p);
    std::unordered_map<uint64_t, uint32_t> clusters;
    for (uint32_t i = 0; i < shooters_.size(); ++i) {
      const Bounds& thing = bounds[things[i]];
      if (thing.diagonal() > kSmall * size_) continue;
      height_[i] = kThingHeight * thing.diagonal();
      if (things[i] == i)
        sets_.join(clusters.try_emplace(key(shooters_[i], thing.centre(), kNone), i).first->second, i);
    }
  }

  /// Parts sets so that all of a part are seen from its first one: shooters hidden from there are a part of their own,
  /// and so on. What is buried stays with the first part.
  std::vector<uint32_t> part_by_sight() {
    std::vector<uint32_t> first(shooters_.size(), kNone), part, left;
    for (uint32_t i = 0; i < shooters_.size(); ++i) {
      if (buried_[i]) continue;
      left.push_back(i);
      first[sets_.find(i)] = std::min(first[sets_.find(i)], i);
    }
    for (uint32_t i = 0; i < shooters_.size(); ++i) {
      const uint32_t set = sets_.find(i);
      part.push_back(first[set] == kNone ? set : first[set]);
    }
    std::vector<float> seen(shooters_.size());
    for (int round = 0; round < kMostRounds && !left.empty(); ++round) {
      for (const uint32_t i : left) first[sets_.find(i)] = kNone, seen[i] = 0;
      VisibilityQueue queue(visibility_, Coherence::coherent, seen.data());
      for (const uint32_t i : left) {
        uint32_t& from = first[sets_.find(i)];
        if (from == kNone) from = i, seen[i] = 1;
        part[i] = from;
        if (from != i) queue.add(between(from, i), i);
      }
      queue.flush();
      std::erase_if(left, [&](uint32_t i) { return seen[i] > 0; });
      for (const uint32_t i : left) part[i] = i;
    }
    return part;
  }
  Ray between(uint32_t i, uint32_t k) const {
    const Point3 a = middle_of(shooters_[i].corners), b = middle_of(shooters_[k].corners);
    const float height = std::min({kSightHeight * length(b - a), height_[i], height_[k]}) + visibility_.offset();
    const Point3 eye = a + height * shooters_[i].normal, to = b + height * shooters_[k].normal;
    return {eye, to - eye, 0, 1};
  }

  const Sides& sides_;
  const std::vector<Sides::Shooter>& shooters_;
  float size_;
  const Visibility& visibility_;
  Sets sets_;
  std::vector<float> height_;  // by shooter: the most at which it must see others
  std::vector<uint8_t> buried_;
  Point3 origin_;
};

}  // namespace

ShooterGroups group_shooters(const Sides& sides, double size, const std::vector<float>& open,
                             const Visibility& visibility) {
  return Grouping(sides, float(size), open, visibility).run();
}

}  // namespace aktina
