#include "aktina/radiosity/lightmap/chart.h"

#include <gtest/gtest.h>

#include <set>

#include "radiosity/lightmap/surfaces.h"

namespace aktina {
namespace {

double flat_area(const Chart& chart) {
  double sum = 0;
  for (const FlatTriangle& t : chart.corners) sum += 0.5 * std::fabs(double(twice_area(t)));
  return sum;
}

void expect_partition(const LightmapSurface& surface, const std::vector<Chart>& charts) {
  std::multiset<uint32_t> seen;
  for (const Chart& chart : charts) {
    ASSERT_EQ(chart.triangles.size(), chart.corners.size());
    seen.insert(chart.triangles.begin(), chart.triangles.end());
    EXPECT_EQ(flat_overlap(chart.corners).count, 0u);
    for (const FlatTriangle& t : chart.corners)
      for (const Vec2 p : t) {
        EXPECT_TRUE(p.x >= 0 && p.y >= 0 && p.x <= chart.size.x && p.y <= chart.size.y);
      }
    EXPECT_GE(chart.size.x, chart.size.y * 0.9999f);
  }
  ASSERT_EQ(seen.size(), surface.size());
  for (uint32_t t = 0; t < surface.size(); ++t) EXPECT_EQ(seen.count(t), 1u);
}

/// Each triangle keeps its area but for the tilt that charts allow.
void expect_little_distortion(const LightmapSurface& surface, const std::vector<Chart>& charts) {
  for (const Chart& chart : charts)
    for (size_t i = 0; i < chart.triangles.size(); ++i) {
      const float flat = 0.5f * std::fabs(twice_area(chart.corners[i])), area = surface.areas[chart.triangles[i]];
      EXPECT_LE(flat, area * 1.001f);
      EXPECT_GE(flat, area * kLeastChartCosine * 0.999f);
    }
}

TEST(Charts, ATurnedRectangleIsOneChartOfItsSize) {
  Scene scene;
  add_quad(scene, {1, 2, 3}, Vec3(3, 1, 0), 0.5f * normalize(Vec3(-1, 3, 0)), Rgb(0.5f));
  const LightmapSurface surface = test::surface_of_mesh(scene.meshes[0]);
  const std::vector<Chart> charts = make_charts(surface);
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_NEAR(charts[0].size.x, std::sqrt(10.0f), 1e-5f);
  EXPECT_NEAR(charts[0].size.y, 0.5f, 1e-5f);
}

TEST(Charts, ABallIsAFewChartsOfLittleDistortion) {
  const LightmapSurface surface = test::surface_of_mesh(test::ball(24));
  const std::vector<Chart> charts = make_charts(surface);
  expect_partition(surface, charts);
  expect_little_distortion(surface, charts);
  EXPECT_GE(charts.size(), 6u);
  EXPECT_LE(charts.size(), 40u);
  double sum = 0;
  for (const Chart& chart : charts) sum += flat_area(chart);
  EXPECT_GT(sum, 0.85 * 4 * kPi);
}

TEST(Charts, HardEdgesAreBorders) {
  Scene scene;
  add_box(scene, Point3(0), Vec3(1), Rgb(0.5f));
  Mesh box;  // one mesh with the corners of a cube, each three times
  for (const Mesh& side : scene.meshes) {
    const auto first = uint32_t(box.positions.size());
    box.positions.insert(box.positions.end(), side.positions.begin(), side.positions.end());
    box.normals.insert(box.normals.end(), side.normals.begin(), side.normals.end());
    for (const auto& t : side.triangles) box.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const LightmapSurface surface = test::surface_of_mesh(box);
  const std::vector<Chart> charts = make_charts(surface);
  expect_partition(surface, charts);
  EXPECT_EQ(charts.size(), 6u);
}

TEST(Charts, ARampThatWindsIsCutWhereItWouldLieUponItself) {
  const LightmapSurface surface = test::surface_of_mesh(test::helix(3, 300));
  const std::vector<Chart> charts = make_charts(surface);
  expect_partition(surface, charts);
  EXPECT_GE(charts.size(), 3u);
  EXPECT_LE(charts.size(), 12u);
}

TEST(Charts, TrianglesWithoutAreaHaveNoPlace) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 0, 0}};
  const LightmapSurface surface = test::surface_of_mesh(mesh);
  EXPECT_EQ(surface.size(), 1u);
  EXPECT_EQ(make_charts(surface).size(), 1u);
}

TEST(Charts, ManyTrianglesAboutOneCorner) {
  Mesh fan;
  constexpr uint32_t kMany = 3000;
  fan.positions.emplace_back(0);
  for (uint32_t i = 0; i < kMany; ++i) {
    const double phi = 2 * kPi * i / kMany;
    fan.positions.emplace_back(std::cos(phi), std::sin(phi), 0);
    fan.triangles.push_back({0, i + 1, (i + 1) % kMany + 1});
  }
  const LightmapSurface surface = test::surface_of_mesh(fan);
  expect_partition(surface, make_charts(surface));
}

}  // namespace
}  // namespace aktina
