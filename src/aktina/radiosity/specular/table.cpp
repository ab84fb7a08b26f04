// The methods that add specular light to radiosity: the only list.
#include "aktina/radiosity/specular/specular.h"

namespace aktina {

extern const Method<std::unique_ptr<SpecularMethod>> two_pass_specular;

std::span<const Method<std::unique_ptr<SpecularMethod>>* const> specular_methods() {
  static constexpr const Method<std::unique_ptr<SpecularMethod>>* kTable[] = {&two_pass_specular};
  return kTable;
}

LayeredImage render_two_pass(const Scene& scene, const Solution& solution, const Camera& camera, int width, int height,
                             const TwoPassOptions& options, Progress* progress) {
  return make_method(specular_methods(), "specular", options.method)
      ->render(scene, solution, camera, width, height, options, progress);
}

}  // namespace aktina
