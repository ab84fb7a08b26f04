// The exact method past occluders.
#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/formfactor/matrix.h"
#include "aktina/radiosity/formfactor/occluded.h"
#include "aktina/radiosity/formfactor/polygon_to_polygon.h"
#include "polygons.h"

namespace aktina {
namespace {

double past(const Polygon& a, const Polygon& b, std::vector<Polygon> occluders, const std::string& method = "contour") {
  return form_factor_matrix({{a, b}, std::move(occluders)}, method).factors[1];
}
Polygon screen(double x0, double x1, double y0, double y1, double z) {
  return {{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}};
}

TEST(Contour, AHalfPlaneHalfwayLeavesHalf) {
  const double all = past(unit_square(), ceiling(1), {});
  EXPECT_NEAR(past(unit_square(), ceiling(1), {screen(0.5, 10, -10, 10, 0.5)}), all / 2, 1e-12);
  EXPECT_EQ(past(unit_square(), ceiling(1), {screen(-1, 2, -1, 2, 0.5)}), 0);
  EXPECT_EQ(past(unit_square(), ceiling(1), {screen(-1, 2, -1, 2, 1.5)}), all);
  EXPECT_EQ(past(unit_square(), ceiling(1), {screen(-1, 2, -1, 2, -0.5)}), all);
  EXPECT_EQ(past(unit_square(), ceiling(1), {screen(-1, 0, -1, 2, 0.5)}), all) << "it touches the lines of sight";
}

TEST(Contour, ComplementaryScreensShareTheLight) {
  const double all = past(unit_square(), ceiling(1), {});
  const Polygon inner = screen(0.2, 0.7, 0.3, 0.8, 0.4);
  const std::vector<Polygon> frame = {screen(-9, 0.2, -9, 9, 0.4), screen(0.7, 9, -9, 9, 0.4),
                                      screen(0.2, 0.7, -9, 0.3, 0.4), screen(0.2, 0.7, 0.8, 9, 0.4)};
  EXPECT_NEAR(past(unit_square(), ceiling(1), {inner}) + past(unit_square(), ceiling(1), frame), all, 3e-8);
}

TEST(Contour, ConcaveAndDoubledAndSplitOccludersHideTheSame) {
  const Polygon l{
      {{0.2, 0.2, 0.5}, {0.8, 0.2, 0.5}, {0.8, 0.4, 0.5}, {0.4, 0.4, 0.5}, {0.4, 0.9, 0.5}, {0.2, 0.9, 0.5}}};
  const std::vector<Polygon> parts = {screen(0.2, 0.8, 0.2, 0.4, 0.5), screen(0.2, 0.4, 0.4, 0.9, 0.5)};
  const double once = past(unit_square(), ceiling(1), {l});
  EXPECT_NEAR(past(unit_square(), ceiling(1), parts), once, 2e-8);
  EXPECT_NEAR(past(unit_square(), ceiling(1), {l, l, turned_over(l)}), once, 2e-8);
}

TEST(Contour, OccludersOnlyHideAndTheErrorIsHonest) {
  const Face a = face(unit_square()), b = face(ceiling(1));
  Pcg32 random(5);
  for (int i = 0; i < 10; ++i) {
    Polygon triangle;
    for (int k = 0; k < 3; ++k)
      triangle.vertices.push_back({random.uniform_double(), random.uniform_double(), random.uniform_double()});
    const Face o = face(triangle);
    const Face* list[] = {&o};
    const Estimate coarse = exchange_area(a, b, list, 1e-3), fine = exchange_area(a, b, list, 1e-6);
    EXPECT_LE(fine.value, exchange_area(a, b));
    EXPECT_GE(fine.value, 0);
    EXPECT_LE(std::abs(coarse.value - fine.value), coarse.error + fine.error + 1e-12);
  }
}

TEST(Contour, SurfacesHideEachOtherOnBothSides) {
  // A wall in the middle of a long box parts it in two closed halves.
  std::vector<Polygon> walls = box(2, 1, 1);
  walls.push_back({{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}});
  const FormFactorMatrix f = form_factor_matrix({walls, {}}, "contour:tolerance=1e-5");
  EXPECT_EQ(f.factors[3 * 7 + 5], 0) << "the two ends";
  EXPECT_NEAR(f.factors[3 * 7 + 6], 0.19982489569838738, 1e-7) << "the end and the front of the wall that faces it";
}

TEST(Contour, ErrorsNameThePolygon) {
  try {
    form_factor_matrix({{unit_square(), {{{0, 0, 0}, {1, 0, 0}}}}, {}}, "contour");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "surface 1");
  }
  EXPECT_THROW(form_factor_matrix({{}, {}}, "contour:tolerance=2"), Error);
  EXPECT_THROW(form_factor_matrix({{}, {}}, "best"), Error);
  EXPECT_EQ(form_factor_matrix({{}, {}}, "contour").factors.size(), 0U);
}

TEST(Analytic, ConvergesToTheExactOneAtHighOrder) {
  const auto error = [](int points) {
    return std::abs(past(unit_square(), ceiling(0.5), {}, "analytic:points=" + std::to_string(points)) -
                    past(unit_square(), ceiling(0.5), {}));
  };
  EXPECT_LT(error(6), 1e-6);
  EXPECT_LT(error(12), error(6) / 100) << "Gauss' rule on a smooth integrand converges exponentially";
}

TEST(Analytic, IsExactForADifferentialArea) {
  const auto method = make_method(formfactors(), "formfactor", "analytic");
  method->build({{ceiling(1)}, {screen(0.5, 10, -10, 10, 0.5)}});
  const FormFactorRow row = method->row({0.5, 0.5, 0}, {0, 0, 2});
  EXPECT_NEAR(row.factors[0], 0.239456470461 / 2, 1e-12) << "the normal need not be of unit length";
}

/// The short block of the Cornell box under the ceiling, past the tall one and a lamp that hangs half a millimetre
/// below.
TEST(Contour, ALampCloseToTheCeilingAndABlockBesideTheOther) {
  const Polygon block{{{0.268166, 0.165, -0.112885},
                       {0.426115, 0.165, -0.065166},
                       {0.473834, 0.165, -0.223115},
                       {0.315885, 0.165, -0.270834}}};
  const Polygon ceiling{{{0, 0.5488, -0.5592}, {0.556, 0.5488, -0.5592}, {0.556, 0.5488, 0}, {0, 0.5488, 0}}};
  const Point3d a(0.133112, 0, -0.248545), b(0.290955, 0, -0.296612), c(0.242888, 0, -0.454455),
      d(0.085045, 0, -0.406388);
  const Vec3d up(0, 0.33, 0);
  const std::vector<Polygon> others = {
      {{a, b, b + up, a + up}},
      {{b, c, c + up, b + up}},
      {{a + up, b + up, c + up, d + up}},
      {{{0.213, 0.5483, -0.332}, {0.343, 0.5483, -0.332}, {0.343, 0.5483, -0.227}, {0.213, 0.5483, -0.227}}}};
  const double exact = 0.3177545;  // 25 million quasi-random pairs of points: +- 1e-6
  for (const char* choice : {"contour:tolerance=1e-5", "cubature:tolerance=1e-5", "hybrid:target_error=1e-6"}) {
    const auto method = make_method(formfactors(), "formfactor", choice);
    method->build({{block, ceiling}, others});
    EXPECT_NEAR(method->row(0).factors[1], exact, 1.3e-5) << choice;
  }
}

}  // namespace
}  // namespace aktina
