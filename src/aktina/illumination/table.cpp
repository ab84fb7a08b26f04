// The illumination models: the only list.
#include "aktina/illumination/model.h"

namespace aktina {

extern const Method<IlluminationModel> lambert_illumination, phong_illumination, blinn_phong_illumination;

std::span<const Method<IlluminationModel>* const> illumination_models() {
  static constexpr const Method<IlluminationModel>* kTable[] = {&lambert_illumination, &phong_illumination,
                                                                &blinn_phong_illumination};
  return kTable;
}

}  // namespace aktina
