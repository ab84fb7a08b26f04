// Form factors of a shot: from every receiving point to the patch that shoots.
#pragma once

#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/solver/shot_geometry.h"
#include "aktina/radiosity/solver/visibility.h"

namespace aktina {

inline constexpr size_t kShotChunk = 256;  // receivers that are looked after together

/// Factor from the middle of a receiver to a shooter as if nothing were in between.
double unoccluded_factor(const ShotGeometry& geometry, size_t shooter, size_t receiver);

/// Multiplies factors of receivers [begin, begin + factors.size()), at most kShotChunk, by the share of shadow rays
/// that get through, from places spread over the receiver to places spread over the shooter, other ones for each
/// receiver. Four times as many where only some do.
/// @param samples  rays of each receiver
void occlude(const ShotGeometry& geometry, const Visibility& visibility, size_t shooter, size_t begin,
             std::span<const int> samples, uint32_t seed, std::span<double> factors);

/// What shoots as seen from the middle of each receiver: Lambert's contour formula times the share of shadow rays that
/// get through. Rays as in J. Wallace, K. Elmquist, E. Haines, "A Ray Tracing Algorithm for Progressive Radiosity",
/// SIGGRAPH 1989; their sum of discs, too low near by, is replaced by the exact factor, so that rays only decide what
/// is in the shade.
/// Cost: one to sixteen rays a receiver that faces what shoots, four times as many in the half shade.
class RayCastShots final : public FactorSource {
 public:
  static constexpr int kMostSamples = 256;
  /// @param samples  shadow rays of a receiver to what shoots near by; emitters get four times as many, what is small
  /// from there gets one
  /// @param surfaces, rays  of the same geometry; rays may be null
  RayCastShots(const ShotGeometry& geometry, const Visibility& visibility, const ReceiverSurfaces& surfaces,
               int samples, uint32_t seed, const LightRays* rays = nullptr)
      : geometry_(geometry),
        visibility_(visibility),
        surfaces_(surfaces),
        samples_(samples),
        seed_(seed),
        rays_(rays) {}
  void column(size_t shooter, std::span<double> factors) const override;
  const LightRays* rays() const override { return rays_; }
  const ReceiverSurfaces* surfaces() const override { return &surfaces_; }

 private:
  const ShotGeometry& geometry_;
  const Visibility& visibility_;
  const ReceiverSurfaces& surfaces_;
  int samples_;
  uint32_t seed_;
  const LightRays* rays_;
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

/// Whether RadiosityOptions::formfactor names rays: "ray_cast" (with `samples`).
bool is_ray_cast(std::string_view formfactor);
/// The `samples` of "ray_cast". @throws Error usage, bad_param
int ray_cast_samples(std::string_view formfactor);

/// Factor from a differential area at x with normal n to a planar triangle or convex quadrilateral, both one-sided; no
/// visibility. Relative error 1e-6; absolute 1e-9.
double point_to_corners(Point3 x, Vec3 n, const std::array<Point3, 4>& corners, Vec3 corners_normal);

}  // namespace aktina
