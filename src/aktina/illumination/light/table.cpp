// The lights: the only list.
#include "aktina/illumination/light/light.h"

namespace aktina {

extern const Method<Light> point_light, spot_light, directional_light, luminaire_light, warn_light, rectangle_light,
    disc_light;

std::span<const Method<Light>* const> lights() {
  static constexpr const Method<Light>* kTable[] = {
      &point_light, &spot_light, &directional_light, &luminaire_light, &warn_light, &rectangle_light, &disc_light};
  return kTable;
}

}  // namespace aktina
