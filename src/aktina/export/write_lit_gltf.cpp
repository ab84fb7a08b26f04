#include "aktina/export/lit_gltf.h"
#include "aktina/radiosity/solve.h"

namespace aktina {

void write_lit_gltf(const Path& path, const Scene& scene, const Solution& solution, const LitGltfOptions& options) {
  const float exposure = options.exposure > 0 ? options.exposure : lit_exposure(solution);
  write_lit_gltf(path, scene, lit_scene(scene, solution), exposure, options.metadata);
}

}  // namespace aktina
