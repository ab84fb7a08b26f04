// The integrators: the only list.
#include "aktina/trace/integrator/integrator.h"

namespace aktina {

extern const Method<std::unique_ptr<Integrator>> whitted_integrator, direct_integrator, path_integrator;

std::span<const Method<std::unique_ptr<Integrator>>* const> integrators() {
  static constexpr const Method<std::unique_ptr<Integrator>>* kTable[] = {&whitted_integrator, &direct_integrator,
                                                                          &path_integrator};
  return kTable;
}

}  // namespace aktina
