// Integrals over triangles of a surface: the one of the largest error is halved until all errors together are small.
#pragma once

#include <array>
#include <vector>

#include "aktina/base/function_ref.h"
#include "aktina/radiosity/formfactor/occluded.h"

namespace aktina {

using Triangle = std::array<Point3d, 3>;

class AdaptiveTriangles {
 public:
  /// @param rule  integral over one triangle, and an estimate of its error; must outlive this
  explicit AdaptiveTriangles(FunctionRef<Estimate(const Triangle&)> rule) : rule_(rule) {}

  /// Adds a triangle, halved so many times.
  void add(const Triangle& triangle, int halvings);
  /// A triangle's error is then at least a quarter of what halving its parent has changed: rules may agree by chance.
  /// @param more  asked before each halving
  void refine(double tolerance, FunctionRef<bool()> more);
  Estimate sum() const;

 private:
  struct Part {
    Triangle triangle;
    Estimate integral;
    bool operator<(const Part& other) const { return integral.error < other.integral.error; }
  };
  void push(const Part& part);

  FunctionRef<Estimate(const Triangle&)> rule_;
  std::vector<Part> parts_;  // a heap
  double error_ = 0;
};

}  // namespace aktina
