// Form factors of a shot: from every receiving point to the patch that shoots.
#pragma once

#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/solver/sides.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

/// The patch as seen from the middle of each receiver: Lambert's contour formula times the share of shadow rays that
/// get through, to places spread over the patch, other ones for each receiver. Rays as in J. Wallace, K. Elmquist,
/// E. Haines, "A Ray Tracing Algorithm for Progressive Radiosity", SIGGRAPH 1989; their sum of discs, too low near by,
/// is replaced by the exact factor, so that rays only decide what is in the shade.
/// Cost: one to sixteen rays a receiver that faces the patch.
class RayCastShots final : public FactorSource {
 public:
  static constexpr int kMostSamples = 256;
  /// @param samples  shadow rays of a receiver to a patch near by; emitters get four times as many, patches that are
  /// small from there one
  RayCastShots(const Sides& sides, const Visibility& visibility, int samples, uint32_t seed)
      : sides_(sides), visibility_(visibility), samples_(samples), seed_(seed) {}
  void column(size_t shooter, std::span<double> factors) const override;

 private:
  void column(size_t shooter, size_t begin, size_t end, std::span<double> factors) const;
  bool look(const Sides::Shooter& from, size_t s, int samples, uint32_t seed, size_t owner,
            VisibilityQueue& queue) const;

  const Sides& sides_;
  const Visibility& visibility_;
  int samples_;
  uint32_t seed_;
};

/// A row of any form-factor method, from the middle of what shoots: one row a shot, as progressive refinement with the
/// hemicube was published. Opaque one-sided patches only. Factors above 1 by reciprocity count as 1.
class RowShots final : public FactorSource {
 public:
  /// @throws Error unsupported (two-sided or transparent patches), bad_input, limit
  RowShots(const Sides& sides, std::unique_ptr<FormFactorMethod> method);
  void column(size_t shooter, std::span<double> factors) const override;

 private:
  const Sides& sides_;
  std::unique_ptr<FormFactorMethod> method_;
};

/// The shots that RadiosityOptions::formfactor names: "ray_cast" (with `samples`), or a row of formfactors().
/// @throws Error usage, bad_param, no_such_method, unsupported, limit
std::unique_ptr<FactorSource> make_shots(std::string_view formfactor, const Sides& sides, const Visibility& visibility,
                                         uint32_t seed);

/// Factor from a differential area at x with normal n to a planar triangle or convex quadrilateral, both one-sided; no
/// visibility. Relative error 1e-6; absolute 1e-9.
double point_to_corners(Point3 x, Vec3 n, const std::array<Point3, 4>& corners, Vec3 corners_normal);

}  // namespace aktina
