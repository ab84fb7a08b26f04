// The fast exchange areas, held to methods of the catalogue.
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/radiosity/formfactor/matrix.h"
#include "aktina/radiosity/viewfactor/blockers.h"
#include "aktina/radiosity/viewfactor/certificate.h"
#include "aktina/radiosity/viewfactor/leaves.h"
#include "radiosity/viewfactor/surfaces.h"

namespace aktina {
namespace {

/// n x n parallelograms of a parallelogram, front as given.
std::vector<Polygon> tiles(const Polygon& whole, int n) {
  const Point3d o = whole.vertices[0];
  const Vec3d u = (whole.vertices[1] - o) / double(n), v = (whole.vertices[3] - o) / double(n);
  std::vector<Polygon> result;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const Point3d p = o + double(i) * u + double(k) * v;
      result.push_back({{p, p + u, p + u + v, p + v}});
    }
  return result;
}

void add(std::vector<Polygon>& all, const std::vector<Polygon>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<Polygon> tiled_box(const std::vector<Polygon>& box, int n) {
  std::vector<Polygon> all;
  for (const Polygon& wall : box) add(all, tiles(wall, n));
  return all;
}

/// The factors between polygons, computed fast by way of n x n tiles of the first `tiled`, are those of the exact
/// method.
void expect_as(const char* method, const std::vector<Polygon>& polygons, size_t tiled, int n, double target) {
  ViewFactorScene scene;
  for (uint32_t i = 0; i < polygons.size(); ++i) {
    scene.names.push_back(std::to_string(i));
    for (Polygon& tile : i < tiled ? tiles(polygons[i], n) : std::vector<Polygon>{polygons[i]})
      scene.pieces.push_back(std::move(tile)), scene.owners.push_back(i);
  }
  const ViewFactors fast = view_factors(scene, {.target_error = target});
  const FormFactorMatrix exact = form_factor_matrix({polygons, {}}, method);
  const size_t count = polygons.size();
  for (size_t i = 0; i < count; ++i)
    for (size_t j = 0; j < count; ++j)
      EXPECT_NEAR(fast.at(i, j), exact.factors[i * count + j], target + 3 * exact.errors[i * count + j])
          << i << " -> " << j;
  const Certificate c = certify(fast);
  EXPECT_LT(c.worst_reciprocity, 1e-14);
  EXPECT_LT(c.largest_excess, 1e-6);
}

constexpr const char* kExact = "contour:tolerance=1e-5";

std::vector<Polygon> room_with_box(double height) {
  std::vector<Polygon> all = box(2, 3, 2);
  for (const Polygon& p : box(0.6, 0.8, 0.5)) all.push_back(moved(turned_over(p), {0.5, 0.9, height}));
  return all;
}

TEST(Exchange, ARoomWithABoxInIt) {
  expect_as(kExact, room_with_box(0.4), 0, 1, 1e-4);
  expect_as(kExact, room_with_box(0.4), 12, 5, 1e-4);
}

TEST(Exchange, RowsOfTilesClose) {
  const std::vector<Polygon> polygons = room_with_box(0.4);
  std::vector<Polygon> all;
  for (const Polygon& p : polygons) add(all, tiles(p, 6));
  const ViewFactors f = view_factors(one_each(all), {});
  for (size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f.row_sum(i), 1, 2e-4) << i;
}

TEST(Exchange, SinglePrecisionIsLeftWhereTheTargetAsksForMore) {
  const std::vector<Polygon> room = tiled_box(box(1, 1, 1), 2);
  const ViewFactors f = view_factors(one_each(room), {.target_error = 1e-8});
  for (size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f.row_sum(i), 1, 1e-9);
}

TEST(Exchange, ABoxOnTheFloorWithoutABottom) {
  std::vector<Polygon> all = room_with_box(0);
  all.erase(all.begin() + 6);
  expect_as(kExact, all, 11, 3, 1e-4);
}

TEST(Exchange, OpenAndInterpenetratingPlates) {
  std::vector<Polygon> all = box(2, 2, 2);
  all.push_back(moved(unit_square(), {0.3, 0.4, 0.7}));
  all.push_back({{{0.8, 0.2, 0.2}, {0.8, 1.8, 0.2}, {0.8, 1.8, 1.5}, {0.8, 0.2, 1.5}}});  // through the first
  expect_as(kExact, all, 8, 3, 5e-4);
}

TEST(Exchange, ConcavePolygonsAndMoreThanFourCorners) {
  std::vector<Polygon> all = box(3, 3, 2);
  all.push_back({{{1, 1, 1}, {2, 1, 1}, {2, 1.3, 1}, {1.3, 1.3, 1}, {1.3, 2, 1}, {1, 2, 1}}});
  Polygon hexagon;
  for (int k = 0; k < 6; ++k)
    hexagon.vertices.push_back({1.8 + 0.4 * std::cos(k * kPi / 3), 2 + 0.4 * std::sin(k * kPi / 3), 0.5});
  all.push_back(hexagon);
  expect_as("monte_carlo:samples=1048576", all, 6, 3, 1e-4);
}

TEST(Exchange, DoesNotDependOnScaleOrPlace) {
  std::vector<Polygon> all = tiled_box(box(2, 2, 2), 2);
  for (const Polygon& p : box(0.6, 0.8, 0.5)) all.push_back(moved(turned_over(p), {0.5, 0.9, 0.4}));
  const ViewFactors f = view_factors(one_each(all), {});
  for (const double scale : {1e-6, 1e6}) {
    std::vector<Polygon> other;
    for (const Polygon& p : all) other.push_back(moved(p, {1024, -512, 256}, scale));
    const ViewFactors g = view_factors(one_each(other), {});
    for (size_t i = 0; i < f.size(); ++i)
      for (size_t j = 0; j < f.size(); ++j) EXPECT_NEAR(f.at(i, j), g.at(i, j), 5e-5) << scale;
  }
}

TEST(Blockers, TilesBecomeOneBodyAndWallsNone) {
  FormFactorScene scene{tiled_box(box(2, 3, 2), 4), {}};
  for (const Polygon& p : box(0.6, 0.8, 0.5)) add(scene.surfaces, tiles(moved(turned_over(p), {0.5, 0.9, 0.4}), 3));
  const std::vector<Blocker> blockers = find_blockers(Faces(scene), 0);
  ASSERT_EQ(blockers.size(), 1U);
  EXPECT_TRUE(blockers[0].closed);
  EXPECT_EQ(blockers[0].faces.size(), 6U);
  for (const Contour& face : blockers[0].faces) EXPECT_EQ(face.size(), 4U);
}

TEST(Leaves, HoldEachSurfaceOnce) {
  const Faces faces({tiled_box(box(2, 3, 2), 5), {}});
  const Leaves leaves = make_leaves(faces);
  std::vector<int> seen(faces.size(), 0);
  for (const Leaf& leaf : leaves.leaves) {
    EXPECT_LE(leaf.count, kLeaf);
    for (uint32_t k = 0; k < leaf.count; ++k) {
      const Fragment& f = leaves.fragments[leaf.first + k];
      ++seen[f.surface];
      EXPECT_NEAR(leaf.plane.height(f.face.centre), 0, 1e-12);
    }
  }
  for (const int count : seen) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace aktina
