#include "aktina/scene/mesh_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace aktina {
namespace {

struct Shape {
  std::vector<Point3> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  MeshCheck check() const { return check_mesh(positions, triangles); }
};

Shape cube() {
  Shape s;
  for (int i = 0; i < 8; ++i) s.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  s.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return s;
}

TEST(MeshCheck, ACubeIsClosed) {
  const MeshCheck c = cube().check();
  EXPECT_TRUE(c.closed());
  EXPECT_EQ(c.edges, 18u);  // Euler: V - E + F = 2
  EXPECT_EQ(c.inconsistent_edges + c.pinched_vertices + c.t_junctions + c.degenerate + c.duplicate, 0u);
  EXPECT_EQ(c.pieces, 1u);
  EXPECT_DOUBLE_EQ(c.area, 6);
  EXPECT_NEAR(c.volume, 1, 1e-12);
  Shape inside_out = cube();
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  EXPECT_NEAR(inside_out.check().volume, -1, 1e-12);
}

TEST(MeshCheck, AMissingFaceLeavesItsEdgesOpen) {
  Shape s = cube();
  s.triangles.erase(s.triangles.begin(), s.triangles.begin() + 2);
  EXPECT_FALSE(s.check().closed());
  EXPECT_EQ(s.check().boundary_edges, 4u);
}

TEST(MeshCheck, VerticesInOnePlaceAreOne) {
  const Shape joined = cube();
  Shape split;
  for (const auto& t : joined.triangles) {
    const auto first = uint32_t(split.positions.size());
    for (const uint32_t v : t) split.positions.push_back(joined.positions[v]);
    split.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(split.check().closed());
}

TEST(MeshCheck, DuplicatesAndDegenerates) {
  Shape s = cube();
  s.triangles.push_back({1, 2, 0});
  s.triangles.push_back({2, 1, 0});  // the other way round
  s.triangles.push_back({0, 0, 1});
  const MeshCheck c = s.check();
  EXPECT_EQ(c.duplicate, 2u);
  EXPECT_EQ(c.degenerate, 1u);
  EXPECT_TRUE(c.closed()) << "the rest is what it was";
}

TEST(MeshCheck, AFlippedTriangleDisagreesWithItsNeighbours) {
  Shape s = cube();
  std::swap(s.triangles[0][0], s.triangles[0][1]);
  EXPECT_EQ(s.check().inconsistent_edges, 3u);
}

TEST(MeshCheck, AMoebiusStripCannotBeOriented) {
  Shape s;
  constexpr uint32_t kSteps = 12;
  for (uint32_t i = 0; i < kSteps; ++i) {
    const double phi = 2 * kPi * i / kSteps;
    for (const double w : {-0.3, 0.3})
      s.positions.emplace_back((1 + w * std::cos(phi / 2)) * std::cos(phi), (1 + w * std::cos(phi / 2)) * std::sin(phi),
                               w * std::sin(phi / 2));
  }
  for (uint32_t i = 0; i < kSteps; ++i) {
    const bool last = i + 1 == kSteps;  // the ends meet turned over
    const uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    s.triangles.push_back({a, b, c});
    s.triangles.push_back({c, b, d});
  }
  const MeshCheck check = s.check();
  EXPECT_EQ(check.inconsistent_edges, 1u) << "one seam, wherever it is put";
  EXPECT_EQ(check.boundary_edges, 2 * kSteps) << "one rim of two turns";
  EXPECT_EQ(check.pieces, 1u);
}

TEST(MeshCheck, ABowtieIsPinched) {
  const Shape s{{{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(s.check().pinched_vertices, 1u);
  EXPECT_EQ(s.check().pieces, 2u);
}

TEST(MeshCheck, ThreeTrianglesAtOneEdge) {
  const Shape s{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_EQ(s.check().non_manifold_edges, 1u);
}

TEST(MeshCheck, ATJunctionIsAVertexWithinAnEdge) {
  const Shape s{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, -1, 0}, {2, -1, 0}},
                {{0, 1, 2}, {0, 4, 3}, {3, 4, 5}, {3, 5, 1}}};
  EXPECT_EQ(s.check().t_junctions, 1u);
}

}  // namespace
}  // namespace aktina
