#include "aktina/illumination/normals/normals.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "aktina/base/random.h"

namespace aktina {
namespace {

FacetWeighting weighting(std::string_view id) { return make_method(normals(), "normals", id); }

/// A fan about the origin whose rim is `rim`, counter-clockwise seen from outside.
std::vector<FacetCorner> fan(const std::vector<Vec3d>& rim) {
  std::vector<FacetCorner> corners;
  for (size_t i = 0; i < rim.size(); ++i) corners.push_back({rim[i], rim[(i + 1) % rim.size()]});
  return corners;
}

/// Points about the +z axis in order of angle, at random radii and depths.
std::vector<Vec3d> random_rim(uint64_t seed, int count) {
  Pcg32 random(seed);
  std::vector<Vec3d> rim;
  for (int i = 0; i < count; ++i) {
    const double phi = 2 * kPi * (i + 0.7 * random.uniform_double()) / count, r = 0.3 + random.uniform_double();
    rim.emplace_back(r * std::cos(phi), r * std::sin(phi), -random.uniform_double());
  }
  return rim;
}

double angle_between(Vec3d a, Vec3d b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// N. Max's claim: exact where the vertex and its neighbours lie on a sphere; the other weightings are not.
TEST(VertexNormals, MaxIsRadialOnASphere) {
  double worst_of_others = 0;
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Pcg32 random(seed);
    const Vec3d centre(random.uniform_double(), random.uniform_double(), -1 - random.uniform_double());
    const double radius = length(centre);
    std::vector<Vec3d> rim = random_rim(seed, 3 + int(random.next() % 6));
    for (Vec3d& p : rim) p = centre + normalize(p - centre) * radius;
    if (angle_between(vertex_normal(weighting("max"), fan(rim)), -centre) > kPi / 2)
      continue;  // a fan turned inside out
    EXPECT_LT(angle_between(vertex_normal(weighting("max"), fan(rim)), -centre), 1e-6) << "seed " << seed;
    for (const char* id : {"plain", "area", "angle"})
      worst_of_others = std::max(worst_of_others, angle_between(vertex_normal(weighting(id), fan(rim)), -centre));
  }
  EXPECT_GT(worst_of_others, 0.1);
}

// G. Thuermer and C. A. Wuethrich's claim: cutting a facet within its plane changes nothing.
TEST(VertexNormals, AngleAndAreaIgnoreHowFacetsAreCut) {
  double plain_change = 0, max_change = 0;
  EXPECT_TRUE(rc::check([&] {
    std::vector<Vec3d> rim = random_rim(*rc::gen::arbitrary<uint64_t>(), *rc::gen::inRange(3, 9));
    std::vector<Vec3d> cut = rim;
    cut.insert(cut.begin() + 1, 0.3 * rim[0] + 0.7 * rim[1]);
    for (const char* id : {"angle", "area"})
      RC_ASSERT(length(vertex_normal(weighting(id), fan(rim)) - vertex_normal(weighting(id), fan(cut))) < 1e-12);
    plain_change = std::max(plain_change, length(vertex_normal(weighting("plain"), fan(rim)) -
                                                 vertex_normal(weighting("plain"), fan(cut))));
    max_change = std::max(
        max_change, length(vertex_normal(weighting("max"), fan(rim)) - vertex_normal(weighting("max"), fan(cut))));
  }));
  EXPECT_GT(plain_change, 0.01);
  EXPECT_GT(max_change, 0.01);
}

TEST(VertexNormals, AllAgreeOnASymmetricFan) {
  std::vector<Vec3d> rim;
  for (int i = 0; i < 7; ++i) rim.emplace_back(std::cos(2 * kPi * i / 7), std::sin(2 * kPi * i / 7), -0.4);
  for (const auto* row : normals())
    EXPECT_LT(length(vertex_normal(row->make(ParamSet(row->info)), fan(rim)) - Vec3d(0, 0, 1)), 1e-14) << row->info.id;
}

TEST(VertexNormals, UnitLengthScaleInvarianceAndReversal) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Vec3d> rim = random_rim(*rc::gen::arbitrary<uint64_t>(), *rc::gen::inRange(3, 9));
    std::vector<Vec3d> scaled = rim, reversed(rim.rbegin(), rim.rend());
    for (Vec3d& p : scaled) p *= 1e-7;
    for (const auto* row : normals()) {
      const FacetWeighting w = row->make(ParamSet(row->info));
      const Vec3d n = vertex_normal(w, fan(rim));
      RC_ASSERT(std::abs(length(n) - 1) < 1e-14);
      RC_ASSERT(length(vertex_normal(w, fan(scaled)) - n) < 1e-12);
      RC_ASSERT(length(vertex_normal(w, fan(reversed)) + n) < 1e-12);
    }
  }));
}

TEST(VertexNormals, DegenerateFacetsAddNothing) {
  std::vector<FacetCorner> corners = fan(random_rim(3, 5));
  for (const auto* row : normals()) {
    const FacetWeighting w = row->make(ParamSet(row->info));
    const Vec3d n = vertex_normal(w, corners);
    std::vector<FacetCorner> more = corners;
    more.push_back({Vec3d(1, 0, 0), Vec3d(1, 0, 0)});
    more.push_back({Vec3d(0), Vec3d(0, 1, 0)});
    EXPECT_EQ(vertex_normal(w, more), n) << row->info.id;
    EXPECT_EQ(vertex_normal(w, {}), Vec3d(0));
    const FacetCorner both_sides[] = {{{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 0, 0}}};
    EXPECT_EQ(vertex_normal(w, both_sides), Vec3d(0));
  }
}

}  // namespace
}  // namespace aktina
