#include "aktina/trace/intersect.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "aktina/trace/primitive/primitive.h"
#include "test_files.h"

namespace aktina {
namespace {

using nlohmann::json;

Vec3d vec(const json& j) { return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()}; }

std::optional<SurfaceHit> intersect_case(const json& c) {
  const json& in = c["inputs"];
  const Line line = {vec(in["origin"]), vec(in["direction"]), 1e-9};
  const std::string kind = c["kind"];
  if (kind == "ray_sphere") return intersect_sphere(line, vec(in["centre"]), in["radius"]);
  if (kind == "ray_plane") return intersect_plane(line, vec(in["normal"]), in["D"]);
  std::vector<Point3d> vertices;
  for (const json& v : in["vertices"]) vertices.push_back(vec(v));
  if (kind == "ray_triangle") return intersect_triangle(line, vertices[0], vertices[1], vertices[2]);
  return intersect_polygon(line, vertices);
}

TEST(Intersect, ReferenceValues) {
  AKTINA_NEEDS_THIRD_PARTY_SCENES();
  std::ifstream file(test::third_party_scenes().parent_path() / "reference" / "whitted.json");
  const json suite = json::parse(file);
  int checked = 0;
  for (const json& c : suite["cases"]) {
    if (c["kind"].get<std::string>().rfind("ray_", 0) != 0) continue;
    const auto hit = intersect_case(c);
    const json& expected = c["expected"];
    ++checked;
    ASSERT_EQ(hit.has_value(), expected["hit"].get<bool>()) << c["id"];
    if (!hit) continue;
    EXPECT_NEAR(hit->t, expected["t"].get<double>(), 1e-10 + 1e-9 * hit->t) << c["id"];
    if (expected.contains("normal")) {
      EXPECT_LT(length(hit->normal - vec(expected["normal"])), 1e-9) << c["id"];
    }
    if (expected.contains("u")) {
      EXPECT_NEAR(hit->u, expected["u"].get<double>(), 1e-9) << c["id"];
      EXPECT_NEAR(hit->v, expected["v"].get<double>(), 1e-9) << c["id"];
    }
  }
  EXPECT_EQ(checked, 80);
}

TEST(Intersect, PolygonIsTheUnionOfItsTriangles) {
  // An L of unit squares: its notch must be missed, its plane tilted.
  const auto lift = [](double x, double y) { return Point3d(x, y, 0.3 * x - 0.2 * y); };
  const std::array l = {lift(0, 0), lift(2, 0), lift(2, 1), lift(1, 1), lift(1, 2), lift(0, 2)};
  for (double x = -0.25; x < 2.5; x += 0.5)
    for (double y = -0.25; y < 2.5; y += 0.5) {
      const bool inside = x > 0 && y > 0 && x < 2 && y < 2 && (x < 1 || y < 1);
      EXPECT_EQ(intersect_polygon({{x, y, 5}, {0, 0, -1}}, l).has_value(), inside) << x << " " << y;
    }
}

}  // namespace
}  // namespace aktina
