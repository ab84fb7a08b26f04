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

TEST(Primitive, HitsLieOnTheSurfaceWithItsNormal) {
  // Implicit form of each shape, and a line through two random points near it.
  EXPECT_TRUE(rc::check([] {
    const auto real = [](double low, double high) {
      return low + (high - low) * double(*rc::gen::inRange(0, 1 << 20)) / (1 << 20);
    };
    const Point3d a(real(-3, 3), real(-3, 3), real(-3, 3)), b(real(-1, 1), real(-1, 2), real(-1, 1));
    RC_PRE(length(b - a) > 1e-3);
    const double r = real(0.1, 1.5), top = real(0, 1.5), h = real(0.1, 2);
    const Cone cone = {float(r), float(top), float(h)};
    const auto field = [&](Point3d p) {
      const double radius = cone.radius + (double(cone.top_radius) - cone.radius) * p.y / cone.height;
      return p.x * p.x + p.z * p.z - radius * radius;
    };
    const Line line = {a, b - a};
    const auto hit = intersect(cone, line);
    // Truth by marching: the first change of sign within the height.
    constexpr int kSteps = 4000;
    double t_truth = -1;
    for (int i = 0; i < kSteps && t_truth < 0; ++i) {
      const double t0 = 4.0 * i / kSteps, t1 = 4.0 * (i + 1) / kSteps;
      const Point3d p = line.at(0.5 * (t0 + t1));
      if (p.y >= 0 && p.y <= cone.height && field(line.at(t0)) * field(line.at(t1)) < 0) t_truth = 0.5 * (t0 + t1);
    }
    if (hit) {
      const Point3d p = line.at(hit->t);
      RC_ASSERT(std::abs(field(p)) < 1e-9);
      RC_ASSERT(std::abs(length(hit->normal) - 1) < 1e-9);
      const double e = 1e-6;
      const Vec3d gradient(field(p + Vec3d(e, 0, 0)) - field(p - Vec3d(e, 0, 0)),
                           field(p + Vec3d(0, e, 0)) - field(p - Vec3d(0, e, 0)),
                           field(p + Vec3d(0, 0, e)) - field(p - Vec3d(0, 0, e)));
      if (length(gradient) > 1e-9) RC_ASSERT(dot(hit->normal, gradient) > 0.999 * length(gradient));
      if (t_truth >= 0) RC_ASSERT(hit->t < t_truth + 2e-3);
    } else {
      RC_ASSERT(t_truth < 0);
    }
  }));
}

TEST(Primitive, FarAwaySphereKeepsItsDigits) {
  // From 10^6 radii away the textbook discriminant b^2 - c has no digits left in single precision.
  const auto hit = intersect(Sphere{1}, Line{{1e6, 0.5, 0}, {-1, 0, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1e6 - std::sqrt(0.75), 1e-9);
  EXPECT_FALSE(intersect(Sphere{1}, Line{{1e6, 1.0000001, 0}, {-1, 0, 0}}));
}

TEST(Primitive, DegenerateShapesAreMissedWithoutHarm) {
  const double values[] = {0, 1, -1, 1e-300, 1e300, NAN, INFINITY};
  for (const Primitive& shape : {Primitive(Sphere{0}), Primitive(Disc{0}), Primitive(Cylinder{0, 0}),
                                 Primitive(Cone{0, 0, 0}), Primitive(Cone{1, 0, 0})})
    for (const double x : values)
      for (const double y : values)
        if (const auto hit = intersect(shape, Line{{x, y, 0}, {y, x, 1}})) {
          EXPECT_FALSE(std::isnan(hit->t));
        }
}

TEST(Primitive, EveryRowMakesItsShape) {
  for (const auto* row : primitives()) {
    ParamSet params(row->info);
    params.set("radius", 3);
    std::visit([](const auto& shape) { EXPECT_EQ(shape.radius, 3); }, row->make(params));
  }
}

}  // namespace
}  // namespace aktina
