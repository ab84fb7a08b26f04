#include "aktina/scene/measuring_field.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numeric>

#include "aktina/base/error.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(MeasuringField, SpacingIsThatOfTheStandard) {
  EXPECT_NEAR(standard_spacing(1, 1), 0.2, 1e-12);
  EXPECT_NEAR(standard_spacing(10, 6), 1, 1e-12);
  EXPECT_NEAR(standard_spacing(10, 1), 0.2, 1e-12);  // a strip: its shorter side counts
  EXPECT_NEAR(standard_spacing(1e6, 1e6), 10, 1e-12);
}

TEST(MeasuringField, GridCoversItsParallelogram) {
  EXPECT_TRUE(rc::check([] {
    const auto real = [] { return float(*rc::gen::inRange(-1000, 1001)) / 250; };
    const Point3 corner(real(), real(), real());
    const Vec3 u(real(), real(), real()), v(real(), real(), real());
    const float area = length(cross(u, v));
    RC_PRE(area > 0.01f);
    const MeasuringField f = grid(corner, u, v, 0.5);
    RC_ASSERT(f.points.size() == size_t(f.columns * f.rows));
    RC_ASSERT(length(f.u) <= 0.5f * 1.0001f && length(f.v) <= 0.5f * 1.0001f);
    RC_ASSERT(std::abs(sum(f.areas) - double(area)) < 1e-4 * double(area));
    Vec3 mean(0);
    for (const Point3 p : f.points) mean += p / float(f.points.size());
    RC_ASSERT(length(mean - (corner + 0.5f * (u + v))) < 1e-4f);
    for (const Vec3 n : f.normals) RC_ASSERT(std::abs(dot(n, cross(u, v)) / area - 1) < 1e-4f);
  }));
}

TEST(MeasuringField, WorkPlaneIsAPlan) {
  Scene scene;
  test::add_mesh(scene, test::quad({0, 0, 4}, {6, 0, 4}, {6, 3, 0}, {0, 3, 0}), test::add_matt(scene, Rgb(0.5f)));
  const MeasuringField f = work_plane(scene, 0.75, 0.5, 1);
  EXPECT_EQ(f.columns, 5);
  EXPECT_EQ(f.rows, 3);
  EXPECT_EQ(f.normals[0], Vec3(0, 1, 0));
  EXPECT_EQ(f.points.front(), Point3(1, 0.75f, 3));
  EXPECT_EQ(f.points.back(), Point3(5, 0.75f, 1));
  EXPECT_THROW(work_plane(scene, 3.5, 0.5), Error);
  EXPECT_THROW(work_plane(scene, 0.75, 2), Error);
}

TEST(MeasuringField, SurfacePointsStandForItsArea) {
  Scene scene;
  const int paint = test::add_matt(scene, Rgb(0.5f));
  scene.materials[size_t(paint)].name = "paint";
  Mat4 mirrored(1);
  mirrored[0][0] = -2;
  test::add_mesh(scene, test::quad({0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}), paint, mirrored);
  const MeasuringField f = surface(scene, "paint", 0.3);
  EXPECT_NEAR(sum(f.areas), 6, 1e-5);
  Vec3 mean(0);
  for (size_t i = 0; i < f.points.size(); ++i) {
    mean += f.points[i] * float(f.areas[i] / 6);
    EXPECT_NEAR(f.normals[i].z, 1, 1e-6) << "a mirrored surface keeps its front";
  }
  EXPECT_LT(length(mean - Point3(-3, 0.5f, 0)), 1e-4f);
  EXPECT_THROW(surface(scene, "nothing"), Error);
}

TEST(MeasuringField, TooManyPointsAreRefused) {
  EXPECT_THROW(grid({0, 0, 0}, {1e6f, 0, 0}, {0, 0, 1e6f}, 1e-3), Error);
  EXPECT_THROW(grid({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, 0.1), Error);
}

}  // namespace
}  // namespace aktina
