// Quadtrees: a uniform mesh to begin with, whose patches are split into four, and these again, where the light on them
// turns out to change fast. Neighbours differ by one level at most; the larger one is anchored to the corners of the
// smaller ones (quadtree_forest.h), so that light is continuous across.
// Cost: light is computed for new patches only. Weakness: what falls between the points of the first mesh is not seen:
// it must be fine enough to see a shadow at all.
//
// M. Cohen, D. Greenberg, D. Immel, P. Brock, "An Efficient Radiosity Approach for Realistic Image Synthesis", IEEE
// CG&A 6(3), 1986; restricted and anchored: D. Baum, S. Mann, K. Smith, J. Winget, "Making Radiosity Usable", SIGGRAPH
// 1991.
#include "aktina/radiosity/mesher/mesher.h"

namespace aktina {

extern const Method<std::unique_ptr<Mesher>> uniform_mesher;

namespace {

class QuadtreeMesher final : public Mesher {
 public:
  explicit QuadtreeMesher(Refinement refinement)
      : refinement_(refinement), first_(uniform_mesher.make(ParamSet(uniform_mesher.info))) {}

  PatchMesh mesh(const Scene& scene, const MeshOptions& options, Warnings& warnings) const override {
    return first_->mesh(scene, options, warnings);
  }
  Refinement refinement() const override { return refinement_; }

 private:
  Refinement refinement_;
  std::unique_ptr<Mesher> first_;
};

constexpr Param kParams[] = {
    {"depth", "1", "how often a patch may be split into four", 3, 0, 8, true},
    {"gradient", "1", "difference of light within a patch from which it is split, in target errors", 20, 0.1, 1000}};

}  // namespace

extern constinit const Method<std::unique_ptr<Mesher>> quadtree_mesher = {
    {"quadtree", "Adaptive quadtrees", "baum1991",
     "Patches split into four where the light on them changes fast; sharp shadows on few patches, which must begin "
     "small enough to see them.",
     kParams},
    [](const ParamSet& p) -> std::unique_ptr<Mesher> {
      return std::make_unique<QuadtreeMesher>(Refinement{int(p["depth"]), p["gradient"]});
    }};

}  // namespace aktina
