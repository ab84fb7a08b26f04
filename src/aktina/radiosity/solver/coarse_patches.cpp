#include "aktina/radiosity/solver/coarse_patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "aktina/radiosity/solver/shooter_groups.h"

namespace aktina {

CoarsePatches::CoarsePatches(const Sides& sides, double size, const std::vector<float>& open,
                             const Visibility& visibility)
    : all_(sides), open_(open) {
  group(size, open, visibility);
  list_sides(open);
}

void CoarsePatches::group(double size, const std::vector<float>& open, const Visibility& visibility) {
  const ShooterGroups groups = group_shooters(all_, size, open, visibility);
  constexpr uint32_t kNone = 0xffffffff;
  std::vector<uint32_t> number(groups.first.size(), kNone);
  for (const uint32_t first : groups.first) {
    if (number[first] == kNone) number[first] = uint32_t(areas_.size()), areas_.push_back(0);
    of_shooter_.push_back(number[first]);
  }
  extents_.assign(areas_.size(), 0);
  for (size_t i = 0; i < groups.first.size(); ++i)
    if (groups.scattered[i]) extents_[of_shooter_[i]] = 1;  // see find_middle()
  first_shooter_.assign(areas_.size() + 1, 0);
  for (const uint32_t patch : of_shooter_) ++first_shooter_[patch + 1];
  std::partial_sum(first_shooter_.begin(), first_shooter_.end(), first_shooter_.begin());
  std::vector<uint32_t> cursor(first_shooter_.begin(), first_shooter_.end() - 1);
  shooters_.resize(of_shooter_.size());
  for (uint32_t i = 0; i < of_shooter_.size(); ++i) shooters_[cursor[of_shooter_[i]]++] = i;
}

double CoarsePatches::open_area(size_t side) const {
  const double area = double(all_.mesh().areas[all_.patch(side)]);
  return open_[side] > 0 ? area * double(open_[side]) : area;
}

void CoarsePatches::list_sides(const std::vector<float>& open) {
  of_side_.resize(all_.size());
  middles_.resize(size()), normals_.resize(size()), buried_.assign(size(), 0);
  sides_.reserve(all_.size()), sums_.reserve(all_.size());
  for (uint32_t patch = 0; patch < size(); ++patch) {
    first_side_.push_back(uint32_t(sides_.size()));
    bool any_open = false;
    const auto each_side = [&](const auto& body) {
      for (const uint32_t shooter : shooters(patch)) {
        const auto range = all_.shooters()[shooter].range;
        for (uint32_t s = range.first; s < range.first + range.count; ++s) body(s);
      }
    };
    each_side([&](uint32_t s) { of_side_[s] = patch, any_open = any_open || open[s] > 0; });
    buried_[patch] = !any_open;
    each_side([&](uint32_t s) {
      if (any_open && open[s] == 0) return;
      areas_[patch] += open_area(s);
      sides_.push_back(s), sums_.push_back(float(areas_[patch]));
    });
  }
  first_side_.push_back(uint32_t(sides_.size()));
  for (uint32_t patch = 0; patch < size(); ++patch) find_middle(patch);
}

void CoarsePatches::find_middle(size_t patch) {
  Vec3d centre(0), normal(0);
  for (const uint32_t s : sides(patch)) {
    const double area = open_area(s);
    centre += area * Vec3d(all_.centre(s)), normal += area * Vec3d(all_.normal(s));
  }
  centre /= areas_[patch];
  uint32_t nearest = sides(patch)[0];
  for (const uint32_t s : sides(patch))
    if (squared_length(Vec3d(all_.centre(s)) - centre) < squared_length(Vec3d(all_.centre(nearest)) - centre))
      nearest = s;
  middles_[patch] = nearest;
  double farthest = 0;
  for (const uint32_t s : sides(patch))
    farthest = std::max(farthest, squared_length(Vec3d(all_.centre(s)) - Vec3d(all_.centre(nearest))));
  extents_[patch] = extents_[patch] > 0 ? std::sqrt(std::max(areas_[patch], 2 * farthest)) : std::sqrt(areas_[patch]);
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

}  // namespace aktina
