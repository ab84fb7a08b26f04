// Functions that light is made of on a node of the tree: constants, polynomials, or small boxes.
//
// All are orthonormal in the area mean: mean(phi_i phi_j) = 1 where i = j, else 0. The first polynomial is 1: its
// coefficient is the mean. Every function of a node is a sum of those of its children,
//
//     phi_i = sum_j push[c][i][j] phi_j of child c
//
// and light on the children is drawn up to the node by  b_i = sum_c sum_j pull[c][i][j] b_j of child c.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "aktina/radiosity/solver/hierarchy/flat_polygon.h"

namespace aktina {

/// Reference coordinates of a node, and the share of its area that the point stands for.
struct BasisPoint {
  double x, y, weight;
};

/// The functions on one shape of node.
struct ShapeBasis {
  bool triangle;
  size_t count = 0;                               // of functions
  std::array<std::vector<double>, 4> push, pull;  // [child]: [of the node][of the child]

  std::vector<BasisPoint> points;  // where kernels are sampled: with n of them per axis, Gauss points
  std::vector<double> values;      // [point][function]
  /// What the basis makes of a sampled function in between, at test points: sums over the samples, [test][point].
  std::vector<BasisPoint> tests;
  std::vector<double> received;  // where light arrives: its projection on the basis
  std::vector<double> sent;      // where it comes from: what pull keeps exact

  /// Powers x^a y^b, [function][3 a + b], of polynomials; empty: function c is 2 on quarter c, 0 elsewhere.
  std::vector<double> powers;
  double value(size_t function, Vec2d at) const;
  /// Means over the node of each function within a convex part of it.
  std::vector<double> moments(const FlatPolygon& part) const;
};

class Basis {
 public:
  /// Polynomials of degree below `order` in each of x and y on parallelograms, below `order` altogether on triangles.
  /// What such a basis gains from one level to the next are Alpert's multiwavelets: M1 (Haar's), M2, M3.
  /// @param order  1, 2 or 3
  static Basis polynomials(int order);
  /// Flatlets F2: a box on each quarter, pulled up so that mean and first moments stay.
  static Basis flatlets();

  const ShapeBasis& of(bool triangle) const { return shapes_[triangle]; }
  size_t most() const { return std::max(shapes_[0].count, shapes_[1].count); }  // functions of a node

 private:
  std::array<ShapeBasis, 2> shapes_;
};

}  // namespace aktina
