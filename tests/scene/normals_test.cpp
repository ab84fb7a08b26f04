#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/scene/primitive.h"

namespace aktina {
namespace {

constexpr float kSmooth = float(kPi);

/// A unit cube of six quads over eight vertices.
Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  const uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
    mesh.triangle_face.insert(mesh.triangle_face.end(), 2, mesh.face_count++);
  }
  return mesh;
}

Mesh without_normals(const Primitive& shape, float tolerance) {
  Mesh mesh = tessellate(shape, tolerance);
  mesh.normals.clear();
  return mesh;
}

Vec3 face_normal(const Mesh& mesh, size_t triangle) {
  return normalize(triangle_cross(mesh, mesh.triangles[triangle]));
}

TEST(GenerateNormals, CreaseSplitsACube) {
  Mesh sharp = cube();
  generate_normals(sharp, 0.5f);
  EXPECT_EQ(sharp.positions.size(), 24U);
  for (size_t t = 0; t < sharp.triangles.size(); ++t)
    for (const uint32_t v : sharp.triangles[t]) EXPECT_NEAR(dot(sharp.normals[v], face_normal(sharp, t)), 1, 1e-6);

  Mesh round = cube();
  generate_normals(round, kSmooth);
  EXPECT_EQ(round.positions.size(), 8U);
  for (size_t v = 0; v < 8; ++v)
    EXPECT_LT(length(round.normals[v] - normalize(round.positions[v] - Vec3(0.5f))), 1e-6) << "quads count once";
}

// Every weighting sees the polygon, not its triangles: at the corners of a cube all of them point along the diagonal.
TEST(GenerateNormals, DiagonalsOfPolygonsDoNotCount) {
  for (const auto* row : normals()) {
    Mesh mesh = cube();
    generate_normals(mesh, kSmooth, row->make(ParamSet(row->info)));
    for (size_t v = 0; v < 8; ++v)
      EXPECT_LT(length(mesh.normals[v] - normalize(mesh.positions[v] - Vec3(0.5f))), 1e-6) << row->info.id;
  }
}

TEST(GenerateNormals, SphereIsRadialAcrossTheSeamAndAtThePoles) {
  Mesh mesh = without_normals(Sphere{2}, 0.01f);
  const size_t before = mesh.positions.size();
  generate_normals(mesh, 0.5236f);
  EXPECT_EQ(mesh.positions.size(), before) << "a smooth surface doubles no vertex";
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_LT(length(mesh.normals[v] - mesh.positions[v] / 2.0f), 0.03f) << v;
}

TEST(GenerateNormals, FlatFacesHaveTheirOwnNormal) {
  Mesh mesh = without_normals(Sphere{1}, 0.05f);
  mesh.triangle_face.clear();
  generate_normals(mesh, 0);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const uint32_t v : mesh.triangles[t]) EXPECT_GT(dot(mesh.normals[v], face_normal(mesh, t)), 1 - 1e-6f);
}

// Two cubes that share an edge: four faces meet there, and no side may leak into the other.
TEST(GenerateNormals, NonManifoldEdgesStaySharp) {
  Mesh mesh = cube(), second = cube();
  for (Point3& p : second.positions) p += Vec3(1, 1, 0);
  mesh.positions.insert(mesh.positions.end(), second.positions.begin(), second.positions.end());
  for (auto t : second.triangles) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  for (const uint32_t face : second.triangle_face) mesh.triangle_face.push_back(face + 6);
  mesh.face_count = 12;
  generate_normals(mesh, kSmooth);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const uint32_t v : mesh.triangles[t]) {
      const Point3 centre = t < 12 ? Point3(0.5f) : Point3(1.5f, 1.5f, 0.5f);
      EXPECT_GT(dot(mesh.normals[v], mesh.positions[v] - centre), 0.4f) << "outwards from its own cube";
    }
}

TEST(GenerateNormals, DegenerateTrianglesAreSkipped) {
  Mesh clean = cube(), dirty = cube();
  dirty.triangles.push_back({0, 0, 1});
  dirty.triangles.push_back({5, 5, 5});
  dirty.triangle_face.insert(dirty.triangle_face.end(), {6, 7});
  dirty.face_count = 8;
  generate_normals(clean, 0.5f);
  generate_normals(dirty, 0.5f);
  for (size_t t = 0; t < clean.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(dirty.normals[dirty.triangles[t][size_t(k)]], clean.normals[clean.triangles[t][size_t(k)]]);
  for (const Vec3 n : dirty.normals) EXPECT_NEAR(length(n), 1, 1e-6);
}

TEST(GenerateNormals, KeepsWhatIsThere) {
  Mesh mesh = tessellate(Sphere{1}, 0.1f);
  const std::vector<Vec3> normals = mesh.normals;
  generate_normals(mesh, 0);
  EXPECT_EQ(mesh.normals, normals);
}

// A cone of a hundred thousand triangles about one vertex: the fan is joined in n log n.
TEST(GenerateNormals, HugeFan) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 0.5f});
  constexpr uint32_t kCount = 100000;
  for (uint32_t i = 0; i < kCount; ++i) {
    const double phi = 2 * kPi * i / kCount;
    mesh.positions.push_back({float(std::cos(phi)), float(std::sin(phi)), 0});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % kCount});
  }
  generate_normals(mesh, 0.5f);
  EXPECT_LT(length(mesh.normals[0] - Vec3(0, 0, 1)), 1e-4);
  EXPECT_EQ(mesh.positions.size(), size_t(kCount) + 1);
}

}  // namespace
}  // namespace aktina
