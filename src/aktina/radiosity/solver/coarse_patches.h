// Neighbouring shooters of about one orientation taken together: what exchanges indirect light, which changes slowly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/radiosity/solver/sides.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// Sides of shooters that belong together (shooter_groups.h).
class CoarsePatches {
 public:
  /// @param size    m, edge of the cells
  /// @param open  by side: the share of its area that light reaches. Sides without do not count where their patch has
  /// others. Must outlive this.
  CoarsePatches(const Sides& sides, double size, const std::vector<float>& open, const Visibility& visibility);

  size_t size() const { return areas_.size(); }
  uint32_t patch_of_shooter(size_t shooter) const { return of_shooter_[shooter]; }
  uint32_t patch_of_side(size_t side) const { return of_side_[side]; }
  double area(size_t patch) const { return areas_[patch]; }  // m^2, what is open
  /// Of a side; of one without any, all of it. m^2
  double open_area(size_t side) const;
  bool partly_open(size_t side) const { return open_[side] > 0 && open_[side] < 1; }
  Point3 centre(size_t patch) const { return all_.centre(middles_[patch]); }  // of the side in the middle
  Vec3 normal(size_t patch) const { return normals_[patch]; }
  uint32_t middle(size_t patch) const { return middles_[patch]; }  // that side
  /// Edge of a square of its area; of a cluster, of a square that holds it. m
  double extent(size_t patch) const { return extents_[patch]; }
  bool buried(size_t patch) const { return buried_[patch]; }

  std::span<const uint32_t> shooters(size_t patch) const {
    return {shooters_.data() + first_shooter_[patch], first_shooter_[patch + 1] - first_shooter_[patch]};
  }
  /// The sides that count.
  std::span<const uint32_t> sides(size_t patch) const {
    return {sides_.data() + first_side_[patch], first_side_[patch + 1] - first_side_[patch]};
  }
  /// A side and a place on it, evenly over the patch's area. Well spread where u is.
  struct Place {
    uint32_t side;
    Point3 point;
  };
  Place place(size_t patch, Vec2 u) const;

  /// Area means of three bands over the sides that count, by patch. @param value  of a side: Rgb
  template <class Value>
  std::vector<double> means(const Value& value) const {
    std::vector<double> out(3 * size(), 0);
    for (size_t patch = 0; patch < size(); ++patch) {
      for (const uint32_t s : sides(patch)) {
        const Rgb v = value(s);
        for (size_t c = 0; c < 3; ++c) out[3 * patch + c] += open_area(s) * double(v[int(c)]);
      }
      for (size_t c = 0; c < 3; ++c) out[3 * patch + c] /= areas_[patch];
    }
    return out;
  }

 private:
  void group(double size, const std::vector<float>& open, const Visibility& visibility);
  void list_sides(const std::vector<float>& open);
  void find_middle(size_t patch);

  const Sides& all_;
  const std::vector<float>& open_;
  std::vector<uint32_t> of_shooter_, of_side_;
  std::vector<uint32_t> shooters_, first_shooter_, sides_, first_side_;
  std::vector<float> sums_;  // of areas of a patch's sides up to and with each
  std::vector<double> areas_, extents_;
  std::vector<uint32_t> middles_;
  std::vector<Vec3> normals_;
  std::vector<uint8_t> buried_;
};

}  // namespace aktina
