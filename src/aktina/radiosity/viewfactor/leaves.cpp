#include "aktina/radiosity/viewfactor/leaves.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "aktina/base/error.h"
#include "aktina/radiosity/viewfactor/receiver_points.h"
#include "aktina/radiosity/viewfactor/welder.h"

namespace aktina {
namespace {

std::vector<Fragment> fragments_of(const Faces& faces) {
  std::vector<Fragment> fragments;
  for (uint32_t i = 0; i < faces.size(); ++i) {
    const Face& face = faces[i];
    if (face.convex.size() == 1 && face.vertices.size() <= 4) {
      fragments.push_back({face, i});
      continue;
    }
    for (const Contour& piece : face.convex)
      for (size_t k = 1; k + 1 < piece.size(); k += 2) {
        Polygon part{{piece[0], piece[k], piece[k + 1]}};
        if (k + 2 < piece.size()) part.vertices.push_back(piece[k + 2]);
        try {
          fragments.push_back({make_face(part, ""), i});
        } catch (const Error&) {  // a sliver without area
        }
      }
  }
  return fragments;
}

/// Fragments of one plane by rounding, as in merge_coplanar().
std::vector<std::vector<uint32_t>> planes_of(const std::vector<Fragment>& fragments, double tolerance) {
  std::map<std::array<int64_t, 4>, std::vector<uint32_t>> planes;
  const auto cell = [](double x, double size) { return int64_t(std::llround(x / size)); };
  for (uint32_t i = 0; i < fragments.size(); ++i) {
    const Plane& plane = fragments[i].face.plane;
    planes[{cell(plane.normal.x, 1e-7), cell(plane.normal.y, 1e-7), cell(plane.normal.z, 1e-7),
            cell(dot(plane.normal, plane.point), tolerance)}]
        .push_back(i);
  }
  std::vector<std::vector<uint32_t>> result;
  for (auto& [key, members] : planes) result.push_back(std::move(members));
  return result;
}

class LeafMaker {
 public:
  explicit LeafMaker(const Faces& faces) : fragments_(fragments_of(faces)) {
    std::vector<SurfaceSample> points;
    for (Fragment& f : fragments_) {
      points.clear();
      add_gauss_points(f.face.vertices, 2, points);
      std::copy_n(points.begin(), 4, f.gauss_2x2.begin());
    }
    double size = 0;
    for (const Fragment& f : fragments_)
      size = std::max(size, length(f.face.centre - fragments_[0].face.centre) + f.face.radius);
    for (std::vector<uint32_t>& plane : planes_of(fragments_, 1e-9 * size)) split(plane.data(), plane.size());
  }
  Leaves take() { return std::move(result_); }

 private:
  /// Halves along the longer side until a leaf holds all.
  void split(uint32_t* members, size_t count) {
    if (count <= kLeaf) return add_leaf(members, count);
    Point3d low(INFINITY), high(-INFINITY);
    for (size_t k = 0; k < count; ++k) {
      low = glm::min(low, fragments_[members[k]].face.centre);
      high = glm::max(high, fragments_[members[k]].face.centre);
    }
    const Vec3d size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double same = 1e-7 * std::max({size.x, size.y, size.z});
    const auto key = [&](uint32_t i, int k) { return std::llround(fragments_[i].face.centre[(axis + k) % 3] / same); };
    std::sort(members, members + count, [&](uint32_t a, uint32_t b) {
      for (int k = 0; k < 3; ++k)
        if (const auto x = key(a, k), y = key(b, k); x != y) return x < y;
      return a < b;
    });
    const size_t full = ((count + 1) / 2 + kLeaf - 1) / kLeaf * kLeaf, half = full < count ? full : count / 2;
    split(members, half);
    split(members + half, count - half);
  }

  void add_leaf(const uint32_t* members, size_t count) {
    Leaf leaf{};
    leaf.first = uint32_t(result_.fragments.size()), leaf.count = uint32_t(count);
    leaf.plane = fragments_[members[0]].face.plane;
    for (size_t k = 0; k < count; ++k) {
      result_.fragments.push_back(fragments_[members[k]]);
      leaf.largest = std::max(leaf.largest, result_.fragments.back().face.radius);
    }
    surround(leaf);
    line_up(leaf);
    result_.leaves.push_back(leaf);
  }

  void line_up(Leaf& leaf) const {
    for (uint32_t lane = 0; lane < kLeaf; ++lane) {
      const Contour& v = result_.fragments[leaf.first + std::min(lane, leaf.count - 1)].face.vertices;
      for (size_t k = 0; k < 4; ++k)
        for (int axis = 0; axis < 3; ++axis) leaf.corners[k][axis][lane] = v[std::min(k, v.size() - 1)][axis];
    }
  }

  void surround(Leaf& leaf) const {
    const Contour& first = result_.fragments[leaf.first].face.vertices;
    const Vec3d n = leaf.plane.normal, u = normalize(first[1] - first[0]), v = normalize(cross(n, u));
    double low_u = INFINITY, high_u = -INFINITY, low_v = INFINITY, high_v = -INFINITY;
    for (uint32_t k = 0; k < leaf.count; ++k)
      for (const Point3d& p : result_.fragments[leaf.first + k].face.vertices) {
        const double a = dot(p - leaf.plane.point, u), b = dot(p - leaf.plane.point, v);
        low_u = std::min(low_u, a), high_u = std::max(high_u, a), low_v = std::min(low_v, b),
        high_v = std::max(high_v, b);
      }
    const auto corner = [&](double a, double b) { return leaf.plane.point + a * u + b * v; };
    leaf.hull = {corner(low_u, low_v), corner(high_u, low_v), corner(high_u, high_v), corner(low_u, high_v)};
    leaf.centre = 0.5 * (leaf.hull[0] + leaf.hull[2]), leaf.radius = 0.5 * length(leaf.hull[2] - leaf.hull[0]);
  }

  std::vector<Fragment> fragments_;
  Leaves result_;
};

}  // namespace

Leaves make_leaves(const Faces& faces) { return LeafMaker(faces).take(); }

}  // namespace aktina
