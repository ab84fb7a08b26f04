// Two-scale relations, vanishing moments, and what each basis reproduces.
#include "aktina/radiosity/solver/hierarchy/basis.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aktina {
namespace {

std::vector<Basis> all_bases() {
  return {Basis::polynomials(1), Basis::polynomials(2), Basis::polynomials(3), Basis::flatlets()};
}

/// Coefficients of a function on each child, drawn up to the node.
std::vector<double> pulled(const ShapeBasis& shape, const std::array<std::vector<double>, 4>& children) {
  std::vector<double> out(shape.count, 0);
  for (size_t c = 0; c < 4; ++c)
    for (size_t i = 0; i < shape.count; ++i)
      for (size_t j = 0; j < shape.count; ++j) out[i] += shape.pull[c][i * shape.count + j] * children[c][j];
  return out;
}

std::array<std::vector<double>, 4> pushed(const ShapeBasis& shape, const std::vector<double>& node) {
  std::array<std::vector<double>, 4> out;
  for (size_t c = 0; c < 4; ++c) {
    out[c].assign(shape.count, 0);
    for (size_t i = 0; i < shape.count; ++i)
      for (size_t j = 0; j < shape.count; ++j) out[c][j] += node[i] * shape.push[c][i * shape.count + j];
  }
  return out;
}

TEST(Basis, PushThenPullIsTheIdentity) {
  for (const Basis& basis : all_bases())
    for (const bool triangle : {false, true}) {
      const ShapeBasis& shape = basis.of(triangle);
      for (size_t i = 0; i < shape.count; ++i) {
        std::vector<double> unit(shape.count, 0);
        unit[i] = 1;
        const std::vector<double> back = pulled(shape, pushed(shape, unit));
        for (size_t j = 0; j < shape.count; ++j) EXPECT_NEAR(back[j], unit[j], 1e-12);
      }
    }
}

TEST(Basis, TwoScaleMatricesOfM2AreThoseOfThePaper) {
  // In one dimension, of orthonormal functions 1 and sqrt3 (2 x - 1): child-left 1/sqrt2 [[1, 0], [-sqrt3/2, 1/2]].
  const ShapeBasis shape = Basis::polynomials(2).of(false);
  ASSERT_EQ(shape.count, 4U);
  const double one[2][2][2] = {{{1, 0}, {-std::sqrt(3) / 2, 0.5}}, {{1, 0}, {std::sqrt(3) / 2, 0.5}}};
  for (size_t c = 0; c < 4; ++c)
    for (size_t i = 0; i < 4; ++i)  // functions: 1, y, x, x y
      for (size_t j = 0; j < 4; ++j)
        EXPECT_NEAR(shape.push[c][4 * i + j], one[c & 1][i / 2][j / 2] * one[c / 2][i % 2][j % 2], 1e-12);
}

TEST(Basis, FunctionsAreOrthonormalAndAConstantHasOneCoefficient) {
  for (int order = 1; order <= 3; ++order)
    for (const bool triangle : {false, true}) {
      const ShapeBasis shape = Basis::polynomials(order).of(triangle);
      EXPECT_EQ(shape.count, size_t(triangle ? order * (order + 1) / 2 : order * order));
      for (size_t i = 0; i < shape.count; ++i)
        for (size_t j = 0; j < shape.count; ++j) {
          double sum = 0;
          for (size_t c = 0; c < 4; ++c)
            for (size_t k = 0; k < shape.count; ++k)
              sum += shape.push[c][i * shape.count + k] * shape.push[c][j * shape.count + k] / 4;
          EXPECT_NEAR(sum, i == j ? 1 : 0, 1e-12) << "L L^T + R R^T = I";
        }
      const FlatPolygon whole =
          triangle ? FlatPolygon{{0, 0}, {1, 0}, {0, 1}} : FlatPolygon{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      const std::vector<double> constant = shape.moments(whole);
      for (size_t i = 0; i < shape.count; ++i) EXPECT_NEAR(constant[i], i == 0 ? 1 : 0, 1e-12);
    }
}

/// Drawn up from its children and pushed down again a polynomial stays itself exactly when its wavelets vanish.
double lost(const ShapeBasis& shape, int power) {
  std::array<std::vector<double>, 4> children;
  for (int c = 0; c < 4; ++c) {
    children[size_t(c)].assign(shape.count, 0);
    for (size_t p = 0; p < shape.points.size(); ++p)
      for (size_t i = 0; i < shape.count; ++i) {
        const Vec2d at = in_parent(shape.triangle, c, {shape.points[p].x, shape.points[p].y});
        children[size_t(c)][i] += shape.points[p].weight * shape.values[p * shape.count + i] * std::pow(at.x, power);
      }
  }
  const auto again = pushed(shape, pulled(shape, children));
  double off = 0;
  for (size_t c = 0; c < 4; ++c)
    for (size_t i = 0; i < shape.count; ++i) off = std::max(off, std::abs(again[c][i] - children[c][i]));
  return off;
}

TEST(Basis, WaveletsAnnihilatePolynomialsBelowTheirOrder) {
  for (const bool triangle : {false, true})
    for (int order = 1; order <= 3; ++order) {
      const ShapeBasis shape = Basis::polynomials(order).of(triangle);
      for (int power = 0; power < order; ++power) EXPECT_LT(lost(shape, power), 1e-12) << order << " " << power;
      EXPECT_GT(lost(shape, order), 1e-3) << order;
    }
}

TEST(Basis, FlatletsKeepFirstMomentsWhenPulled) {
  for (const bool triangle : {false, true}) {
    const ShapeBasis shape = Basis::flatlets().of(triangle);
    std::array<std::vector<double>, 4> children;
    Vec3d fine(0), coarse(0);
    for (int c = 0; c < 4; ++c)
      for (size_t j = 0; j < 4; ++j) {
        const double value = std::sin(3.0 * c + double(j) + 1);
        children[size_t(c)].push_back(value);
        const Vec2d at = in_parent(triangle, c, {shape.points[j].x, shape.points[j].y});
        fine += value / 16 * Vec3d(1, at.x, at.y);
      }
    const std::vector<double> node = pulled(shape, children);
    for (size_t i = 0; i < 4; ++i) coarse += node[i] / 4 * Vec3d(1, shape.points[i].x, shape.points[i].y);
    EXPECT_LT(length(fine - coarse), 1e-12);
  }
}

TEST(Basis, PartsOfANodeAddUpToItsMoments) {
  for (const Basis& basis : all_bases())
    for (const bool triangle : {false, true}) {
      const ShapeBasis& shape = basis.of(triangle);
      const FlatPolygon square = {{-0.5, -0.5}, {1.5, -0.5}, {1.5, 1.5}, {-0.5, 1.5}};
      FlatPolygon low = square, high = square;
      cut_by_line(low, 0.4, -0.3, -1), cut_by_line(high, -0.4, 0.3, 1);
      FlatPolygon whole = square;
      for (FlatPolygon* each : {&low, &high, &whole}) cut_by_reference(*each, triangle);
      const auto a = shape.moments(low), b = shape.moments(high), all = shape.moments(whole);
      for (size_t i = 0; i < shape.count; ++i) EXPECT_NEAR(a[i] + b[i], all[i], 1e-12);
    }
}

}  // namespace
}  // namespace aktina
