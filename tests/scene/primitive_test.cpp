#include "aktina/scene/primitive.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aktina {
namespace {

double mesh_area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += 0.5 * double(length(triangle_cross(mesh, t)));
  return sum;
}

const Primitive kShapes[] = {Sphere{1.5f}, Disc{2}, Cylinder{0.5f, 3}, Cone{1, 0, 2}, Cone{1, 0.25f, 2}};

// The tessellation is inscribed: its area comes from below, with the tolerance (second order in the segment length).
TEST(Primitive, TessellatedAreaConvergesWithTheTolerance) {
  for (const Primitive& shape : kShapes) {
    const double coarse = area(shape) - mesh_area(tessellate(shape, 4e-3f));
    const double fine = area(shape) - mesh_area(tessellate(shape, 1e-3f));
    EXPECT_GT(fine, 0) << shape.index();
    EXPECT_NEAR(coarse / fine, 4, 0.6) << shape.index();
  }
}

TEST(Primitive, VerticesLieOnTheSurfaceWithinItsBounds) {
  for (const Primitive& shape : kShapes) {
    const Mesh mesh = tessellate(shape, 0.01f);
    const Bounds claimed = bounds(shape), found = bounds(mesh);
    EXPECT_LT(length(claimed.low - found.low), 0.02f) << shape.index();
    EXPECT_LT(length(claimed.high - found.high), 0.02f) << shape.index();
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3 outward = triangle_cross(mesh, mesh.triangles[t]);
      for (const uint32_t v : mesh.triangles[t]) EXPECT_GT(dot(outward, mesh.normals[v]), 0) << shape.index();
    }
  }
}

TEST(Primitive, SphereStaysWithinTheTolerance) {
  for (const float tolerance : {0.1f, 0.01f, 0.001f}) {
    const Mesh mesh = tessellate(Sphere{1}, tolerance);
    float worst = 0;
    for (const auto& t : mesh.triangles)
      worst = std::max(worst, 1 - length((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0f));
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, tolerance / 8) << "not wastefully fine";
  }
}

TEST(Primitive, HostileTolerancesAreBounded) {
  for (const float tolerance : {0.0f, -1.0f, 1e-30f, 1e30f, NAN})
    for (const Primitive& shape : kShapes) {
      const Mesh mesh = tessellate(shape, tolerance);
      EXPECT_GE(mesh.triangles.size(), 8U);
      EXPECT_LE(mesh.triangles.size(), 2U * 1024 * 512);
    }
}

}  // namespace
}  // namespace aktina
