#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "aktina/radiosity/formfactor/closed_forms.h"
#include "aktina/radiosity/formfactor/formfactor.h"
#include "radiosity/formfactor/polygons.h"

namespace aktina {
namespace {

FormFactorRow first_row(const FormFactorScene& scene, const char* choice) {
  const auto method = make_method(formfactors(), "formfactor", choice);
  method->build(scene);
  return method->row(0);
}

Polygon square(double half, double z, bool up) {
  Polygon p{{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}};
  if (!up) std::reverse(p.vertices.begin(), p.vertices.end());
  return p;
}

TEST(Cubature, MeetsItsToleranceOnClosedForms) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    const std::string choice = "cubature:tolerance=" + std::to_string(tolerance * 1e9) + "e-9";
    const FormFactorRow opposed = first_row({{square(0.5, 0, true), square(0.5, 1, false)}, {}}, choice.c_str());
    EXPECT_NEAR(opposed.factors[1], opposed_rectangles(1, 1, 1), tolerance);
    const Polygon wall{{{0.5, -0.5, 0}, {0.5, 0.5, 0}, {0.5, 0.5, 1}, {0.5, -0.5, 1}}};
    Polygon facing = wall;
    std::reverse(facing.vertices.begin(), facing.vertices.end());
    const FormFactorRow touching = first_row({{square(0.5, 0, true), facing, wall}, {}}, choice.c_str());
    EXPECT_NEAR(touching.factors[1] + touching.factors[2], perpendicular_rectangles(1, 1, 1), 4 * tolerance);
  }
}

TEST(Cubature, ShadowsAreThoseOfTheContoursWithinTheEstimate) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.4, 0.4), size(0.1, 0.4), height(0.2, 0.8);
  for (int k = 0; k < 12; ++k) {
    FormFactorScene scene{{square(0.5, 0, true), square(0.5, 1, false)}, {}};
    for (int o = 0; o < 2; ++o) {
      Polygon occluder = square(size(random), height(random), true);
      const Vec3d at(place(random), place(random), 0);
      for (Point3d& p : occluder.vertices) p += at;
      scene.occluders.push_back(occluder);
    }
    const FormFactorRow row = first_row(scene, "cubature:tolerance=1e-4");
    const double exact = first_row(scene, "contour:tolerance=1e-7").factors[1];
    EXPECT_NEAR(row.factors[1], exact, row.errors[1] + 1e-6) << k;
    EXPECT_LT(row.errors[1], 1.01e-4);
  }
}

TEST(Cubature, TellsWhereItStoppedAboveTheTolerance) {
  FormFactorScene scene{{square(0.5, 0, true), square(0.5, 1, false)}, {}};
  for (int k = 0; k < 12; ++k) scene.occluders.push_back(square(0.02 + 0.04 * k, 0.05 + 0.07 * k, true));
  const FormFactorRow row = first_row(scene, "cubature:tolerance=1e-9");
  EXPECT_GT(row.errors[1], 1e-9);
}

}  // namespace
}  // namespace aktina
