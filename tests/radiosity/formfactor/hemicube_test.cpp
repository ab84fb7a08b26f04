// What the cells of a hemicube count, and what hemicubes see.
#include "aktina/radiosity/formfactor/hemicube.h"

#include <gtest/gtest.h>

#include "aktina/radiosity/formfactor/matrix.h"
#include "polygons.h"

namespace aktina {
namespace {

TEST(DeltaFormFactors, SumToOneAtSecondOrder) {
  const double known[] = {8.6e-3, 2.1e-3, 5.3e-4, 1.3e-4, 3.3e-5, 8.3e-6};  // by quadrature of the cells' centres
  double previous = 0;
  for (int k = 0; k < 6; ++k) {
    const double error = DeltaFormFactors(8 << k).total() - 1;
    EXPECT_NEAR(error, known[k], 0.03 * known[k]);
    if (k > 0) {
      EXPECT_NEAR(previous / error, 4, 0.1);
    }
    previous = error;
  }
  EXPECT_NEAR(DeltaFormFactors(1024).top_share(), 0.554126424, 1e-6);
}

TEST(DeltaFormFactors, TheTableIsSymmetricAndIsTheKernel) {
  const DeltaFormFactors delta(16);
  EXPECT_EQ(delta.top(3, 5), delta.top(12, 5));
  EXPECT_EQ(delta.top(3, 5), delta.top(5, 3));
  EXPECT_EQ(delta.side(3, 5), delta.side(12, 5));
  const double x = 1.0 / 16, y = 1.0 / 16, z = 15.0 / 16, area = 1.0 / 64;
  EXPECT_DOUBLE_EQ(delta.top(8, 8), area / (kPi * std::pow(x * x + y * y + 1, 2)));
  EXPECT_DOUBLE_EQ(delta.side(8, 0), z * area / (kPi * std::pow(y * y + z * z + 1, 2))) << "row 0 is the uppermost";
}

double at_point(const std::string& method, const FormFactorScene& scene, Point3d x) {
  const auto made = make_method(formfactors(), "formfactor", method);
  made->build(scene);
  return made->row(x, {0, 0, 1}).factors[0];
}

TEST(Hemicube, AliasingOfASquareFallsAsTheCellsShrink) {
  const FormFactorScene scene{{ceiling(1)}, {}};
  const auto rms = [&](int resolution) {
    double sum = 0;
    for (int seed = 0; seed < 40; ++seed) {
      const std::string method =
          "hemicube:hemicubes=1,resolution=" + std::to_string(resolution) + ",seed=" + std::to_string(seed);
      sum += std::pow(at_point(method, scene, {0.5, 0.5, 0}) - 0.239456470461, 2);
    }
    return std::sqrt(sum / 40);
  };
  const double coarse = rms(32), fine = rms(256);
  EXPECT_LT(fine, 3e-4);
  EXPECT_GT(coarse / fine, 6) << "about 1/n over random rotations: 8";
}

TEST(Hemicube, AClosedRoomFillsEveryCell) {
  const FormFactorMatrix f = form_factor_matrix({box(1, 1.5, 0.8), {}}, "hemicube:resolution=64,hemicubes=4");
  expect_closed(f, 6, 1e-3);
}

TEST(Hemicube, OneInTheMiddleIsTheFactorOfThatPointAndManyConvergeToThePatch) {
  const FormFactorScene scene{{unit_square(), ceiling(0.3)}, {}};
  const double exact = form_factor_matrix(scene, "contour").factors[1];
  const double one = form_factor_matrix(scene, "hemicube:resolution=512,hemicubes=1").factors[1];
  EXPECT_NEAR(one, at_point("contour", {{ceiling(0.3)}, {}}, {0.5, 0.5, 0}), 1e-3);
  EXPECT_GT(std::abs(one - exact), 0.1) << "the other integral is missing";
  EXPECT_NEAR(form_factor_matrix(scene, "hemicube:resolution=64,hemicubes=256").factors[1], exact, 3e-3);
}

TEST(Hemicube, BacksHideAndAreNotLit) {
  const Polygon screen{{{-9, -9, 0.5}, {9, -9, 0.5}, {9, 9, 0.5}, {-9, 9, 0.5}}};
  const auto method = make_method(formfactors(), "formfactor", "hemicube");
  method->build({{ceiling(1), screen}, {}});
  EXPECT_EQ(method->row({0.5, 0.5, 0}, {0, 0, 1}).factors, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace aktina
