// Uniform subdivision: every edge is cut into equal pieces no longer than the patch size, whatever face it belongs to;
// faces are grids of quadrilaterals where their edges allow it. Cost: linear in the patches. Weakness: as fine in the
// middle of a wall as at the edge of a shadow.
//
// M. Cohen, D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 1985.
#include "aktina/base/error.h"
#include "aktina/radiosity/mesher/contacts.h"
#include "aktina/radiosity/mesher/subdivision.h"

namespace aktina {
namespace {

class UniformMesher final : public Mesher {
 public:
  explicit UniformMesher(double shooter) : shooter_(shooter) {}

  PatchMesh mesh(const Scene& scene, const MeshOptions& options, Warnings& warnings) const override {
    SceneFaces faces(scene);
    const double area = faces.area();
    if (!(area > 0)) throw Error(Code::bad_input, scene.source, "no surface to compute light on");
    const double size = options.size(area), shooter = shooter_ > 0 ? shooter_ * size : options.coarse_size(area);
    cut_at_contacts(faces, size, warnings);
    return subdivide(scene, faces, {size, shooter}, options.most_patches, warnings);
  }

 private:
  double shooter_;
};

constexpr Param kParams[] = {{"shooter", "1",
                              "longest edge of what shoots light as one, in patch sizes; 0: as indirect light needs it",
                              0, 0, 64}};

}  // namespace

extern constinit const Method<std::unique_ptr<Mesher>> uniform_mesher = {
    {"uniform", "Uniform subdivision", "cohen1985",
     "Patches of one size; neighbours share their edges; simple, finer than needed where nothing happens.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<Mesher> { return std::make_unique<UniformMesher>(p["shooter"]); }};

}  // namespace aktina
