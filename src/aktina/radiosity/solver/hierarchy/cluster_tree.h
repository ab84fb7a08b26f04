// Surfaces put together to clusters, and these to larger ones, up to the one that is the whole scene.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aktina/radiosity/solver/hierarchy/surface_tree.h"

namespace aktina {

/// The six directions along the axes: +x, -x, +y, ...
inline constexpr size_t kAxes = 6;
inline float along_axis(Vec3 v, size_t axis) { return axis % 2 ? -v[int(axis / 2)] : v[int(axis / 2)]; }

struct Cluster {
  Point3 centre;
  float radius;           // of a sphere that holds all of it, m
  double area;            // of its surfaces, m^2
  double across[kAxes];   // their projected area, seen from each axis, m^2
  uint32_t first, count;  // of its roots
  uint32_t children[2];   // places
};

/// A binary tree over the roots of a surface tree, cut at the median along the longest axis. A place in it is a
/// cluster, or a node of the surface tree.
class ClusterTree {
 public:
  /// Roots that are buried are left out. `tree` must outlive this.
  explicit ClusterTree(const SurfaceTree& tree);

  static bool is_cluster(uint32_t place) { return place & kCluster; }
  /// @pre is_cluster(place)
  const Cluster& cluster(uint32_t place) const { return clusters_[number(place)]; }
  static uint32_t number(uint32_t place) { return place & ~kCluster; }
  /// Parents before children; empty where there are fewer than two roots.
  std::span<const Cluster> clusters() const { return clusters_; }
  static uint32_t place(size_t number) { return uint32_t(number) | kCluster; }
  std::span<const uint32_t> roots(const Cluster& cluster) const { return {&roots_[cluster.first], cluster.count}; }

  /// Projected area of a place's surfaces, seen along `direction` from far away, m^2.
  double across(uint32_t place, Vec3 direction) const;
  /// One of its surfaces, by area. @param u  in [0, 1)
  uint32_t root_at(const Cluster& cluster, float u) const;

 private:
  static constexpr uint32_t kCluster = 0x80000000;
  uint32_t build(uint32_t first, uint32_t count);

  const SurfaceTree& tree_;
  std::vector<Cluster> clusters_;
  std::vector<uint32_t> roots_;  // in the order of clusters
  std::vector<double> sums_;     // of areas, up to and with each of them
};

}  // namespace aktina
