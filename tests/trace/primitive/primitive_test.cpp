// sphere, disc, cylinder, cone
#include "aktina/trace/primitive/primitive.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace aktina {
namespace {

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
    // Truth by marching: the first change of sign within the height, a step away from its ends.
    constexpr int kSteps = 4000;
    const double margin = length(b - a) * 4 / kSteps;
    double t_truth = -1;
    for (int i = 0; i < kSteps && t_truth < 0; ++i) {
      const double t0 = 4.0 * i / kSteps, t1 = 4.0 * (i + 1) / kSteps;
      const Point3d p = line.at(0.5 * (t0 + t1));
      if (p.y < margin || p.y > cone.height - margin) continue;
      if (field(line.at(t0)) * field(line.at(t1)) < 0) t_truth = 0.5 * (t0 + t1);
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
