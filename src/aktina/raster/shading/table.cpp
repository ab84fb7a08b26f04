// The shading methods: the only list.
#include "aktina/raster/shading/shading_method.h"

namespace aktina {

extern const ShadingRow flat_shading, gouraud_shading, phong_shading;

std::span<const ShadingRow* const> shading_methods() {
  static constexpr const ShadingRow* kTable[] = {&flat_shading, &gouraud_shading, &phong_shading};
  return kTable;
}

}  // namespace aktina
