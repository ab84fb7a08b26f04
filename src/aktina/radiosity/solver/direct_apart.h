// Direct light apart: each emitter and lamp on every patch; all other light between coarse patches.
//
// Direct light has the sharp edges, indirect light changes slowly: each on the mesh that it needs.
// P. Shirley, "A Ray Tracing Method for Illumination Calculation in Diffuse-Specular Scenes", Graphics Interface 1990.
#pragma once

#include <memory>

#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/coarse_rays.h"
#include "aktina/radiosity/solver/direct_sources.h"
#include "aktina/radiosity/solver/interpolate.h"
#include "aktina/radiosity/solver/receiver_surfaces.h"
#include "aktina/radiosity/solver/shots.h"

namespace aktina {

class DirectApart {
 public:
  /// @param direct  computed here where it is empty
  /// The other arguments must outlive this.
  DirectApart(const Scene& scene, const Sides& sides, const Visibility& visibility, const RadiosityOptions& options,
              const MeshOptions& mesh, DirectLight direct, Progress* progress, KeptDirectLight& kept);

  /// What is left for a solver: coarse patches on which the direct light arrives.
  const RadiosityProblem& problem() const { return problem_; }
  const FactorSource& factors() const { return factors_; }
  /// Weighted flux of emitters and lamps.
  double emitted() const { return emitted_; }

  struct Light {
    std::vector<Rgb> irradiances, direct;  // by side
    RadiosityState account;                // its sums only
  };
  /// The solver's state on all sides.
  Light on_sides(const RadiosityState& coarse) const;

 private:
  void make_problem(const RadiosityProblem& all);
  double absorbed(const std::vector<Rgb>& irradiances) const;

  const Sides& sides_;
  ShooterHits hits_;
  std::vector<float> open_;
  CoarsePatches patches_;
  ShotGeometry geometry_;
  ReceiverSurfaces surfaces_;
  CoarseRays rays_;
  RayCastShots factors_;
  CoarseInterpolation interpolation_;
  std::vector<Rgb> direct_;  // by side
  RadiosityProblem problem_;
  double emitted_ = 0;
};

}  // namespace aktina
