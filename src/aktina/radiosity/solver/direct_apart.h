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
  /// @param groups  the light of each of them apart, in bands of its own
  /// @param direct  of a single group, computed here where it is empty
  /// The other arguments must outlive this.
  DirectApart(const Scene& scene, std::span<const LightGroup> groups, const Sides& sides, const Visibility& visibility,
              const RadiosityOptions& options, const MeshOptions& mesh, DirectLight direct, Progress* progress,
              KeptDirectLight& kept);

  /// What is left for a solver: coarse patches on which the direct light arrives. Three bands for each group; where
  /// there are several, each counts the same, so that a candle is found as exactly as a sun.
  const RadiosityProblem& problem() const { return problem_; }
  const FactorSource& factors() const { return factors_; }
  /// Flux of emitters and lamps of all groups, lm.
  double emitted() const { return emitted_; }

  struct Light {
    std::vector<Rgb> irradiances, direct;  // by side
    RadiosityState account;                // its sums only
  };
  /// The solver's state on all sides, of one group.
  Light on_sides(const RadiosityState& coarse, size_t group = 0) const;

 private:
  struct Group {
    std::vector<Rgb> direct;  // by side
    double emitted;           // lm
  };
  void add_group(const LightGroup& lights, size_t groups, const DirectSources& sources, DirectLight direct);
  void weigh_groups();
  std::vector<double> bands_of(const std::vector<double>& values, size_t group) const;
  double unshot_share(const RadiosityState& coarse, size_t group) const;
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
  std::vector<Group> groups_;
  RadiosityProblem problem_;
  double emitted_ = 0;
};

}  // namespace aktina
