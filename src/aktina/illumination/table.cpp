// The illumination models: the only list.
#include "aktina/illumination/model.h"

namespace aktina {

extern const Method<IlluminationModel> constant_illumination, ambient_illumination, lambert_illumination,
    oren_nayar_illumination, phong_illumination, blinn_phong_illumination, schlick_illumination,
    torrance_sparrow_illumination, cook_torrance_illumination, ward_illumination, ggx_illumination;

std::span<const Method<IlluminationModel>* const> illumination_models() {
  static constexpr const Method<IlluminationModel>* kTable[] = {
      &constant_illumination,      &ambient_illumination,     &lambert_illumination, &oren_nayar_illumination,
      &phong_illumination,         &blinn_phong_illumination, &schlick_illumination, &torrance_sparrow_illumination,
      &cook_torrance_illumination, &ward_illumination,        &ggx_illumination};
  return kTable;
}

}  // namespace aktina
