// Form factors: what fraction of the light that leaves one patch arrives at another. All estimators behind one
// interface, asked for a row at a time; double precision.
//
//     F_ij = 1/A_i  int int  max(0, cos_i) max(0, cos_j) V / (pi r^2)  dA_j dA_i
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "aktina/base/method.h"
#include "aktina/base/vec.h"

namespace aktina {

/// Planar polygon of any shape without holes, one-sided, counter-clockwise seen from its front.
struct Polygon {
  std::vector<Point3d> vertices;  // m, three or more
};
Vec3d newell_normal(const Polygon& polygon);  // unit times area: length is the area, m^2

/// The surfaces among which light travels: receivers, sources and occluders in one list. Occluders block on both sides.
struct FormFactorScene {
  std::vector<Polygon> surfaces;   // what rows and columns stand for
  std::vector<Polygon> occluders;  // what only blocks
};

struct FormFactorRow {
  std::vector<double> factors;  // F_ij for each surface j of the scene
  std::vector<double> errors;   // estimate of each one's absolute error (standard error where sampled)
};

/// An estimator, built once for a scene and asked for rows, from any thread.
class FormFactorMethod {
 public:
  virtual ~FormFactorMethod() = default;
  /// @throws Error bad_input (fewer than three vertices, no area, not planar, not finite), limit, unsupported
  virtual void build(const FormFactorScene& scene) = 0;
  /// Row i. The same values for any number of threads; sampled estimators depend on (seed, i) only.
  virtual FormFactorRow row(size_t i) const = 0;
  /// From a differential area at x with unit normal n to each surface.
  virtual FormFactorRow row(Point3d x, Vec3d n) const = 0;
};

using FormFactorMethodRow = Method<std::unique_ptr<FormFactorMethod>>;
std::span<const FormFactorMethodRow* const> formfactors();

}  // namespace aktina
