// All light on all patches: the problem of a mesh, whose patches may be split while it is solved.
#pragma once

#include <memory>

#include "aktina/radiosity/checkpoint.h"
#include "aktina/radiosity/mesher/quadtree_forest.h"
#include "aktina/radiosity/solver/direct_sources.h"
#include "aktina/radiosity/solver/receiver_surfaces.h"
#include "aktina/radiosity/solver/shots.h"

namespace aktina {

class PatchElements final : public ElementSplitter {
 public:
  /// @param mesh  grows with every split. The arguments must outlive this.
  PatchElements(const Scene& scene, const Visibility& visibility, const Refinement& refinement,
                const RadiosityOptions& options, PatchMesh& mesh, Progress* progress, Checkpoint* checkpoint);

  const Sides& sides() const { return stage_->sides; }
  bool can_split() const { return forest_ != nullptr; }

  bool split(const RadiosityState& state) override;
  const RadiosityProblem& problem() const override { return stage_->problem; }
  const FactorSource& factors() const override { return *stage_->factors; }
  std::span<const uint32_t> origins() const override { return origins_; }
  void column_of_new(size_t shooter, std::span<double> factors) const override;

 private:
  /// What belongs to the mesh as it is.
  struct Stage {
    Stage(const Scene& scene, const Visibility& visibility, const PatchMesh& mesh)
        : sides(mesh), geometry(sides), surfaces(scene, geometry, visibility), problem(sides.problem()) {}
    Sides sides;
    ShotGeometry geometry;
    ReceiverSurfaces surfaces;
    std::unique_ptr<FactorSource> factors;
    RadiosityProblem problem;
  };
  std::unique_ptr<Stage> stage() const;
  void shine_on(std::span<const uint32_t> sides, KeptList<Rgb>& light);
  void prepare_shots_to_new();

  const Scene& scene_;
  const Visibility& visibility_;
  Refinement refinement_;
  const RadiosityOptions& options_;
  PatchMesh& mesh_;
  Progress* progress_;
  std::unique_ptr<QuadtreeForest> forest_;
  std::unique_ptr<Stage> stage_;
  KeptList<Rgb> lamps_;  // on the first sides
  std::vector<uint32_t> origins_, new_;
  std::unique_ptr<ShotGeometry> new_geometry_;
  std::unique_ptr<RayCastShots> shots_to_new_;
};

}  // namespace aktina
