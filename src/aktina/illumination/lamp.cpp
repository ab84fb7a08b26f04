#include "aktina/illumination/lamp.h"

#include <cmath>

namespace aktina {
namespace {

Lamp lamp_of(const DirectionalLight& light) {
  Lamp lamp{};
  lamp.distant = true;
  lamp.place = -light.direction;
  lamp.colour = light.e_perp.v * float(kInvPi);
  return lamp;
}

Lamp lamp_of(const PointLight& light) {
  Lamp lamp{};
  lamp.place = light.position;
  lamp.colour = light.intensity.v * float(kInvPi);
  lamp.attenuation = light.attenuation;
  lamp.inverse_square = light.attenuation == Attenuation();
  return lamp;
}

Lamp lamp_of(const SpotLight& light) {
  Lamp lamp = lamp_of(PointLight{light.position, light.intensity, light.attenuation});
  const float outer = std::cos(light.outer_angle), inner = std::cos(light.inner_angle);
  const bool smooth = inner > outer;
  lamp.cone = true;
  lamp.axis = light.direction;
  lamp.outer_cosine = outer;
  lamp.ramp_scale = smooth ? 1 / (inner - outer) : 0;
  lamp.ramp_offset = smooth ? -outer / (inner - outer) : 1;
  lamp.exponent = light.exponent > 0 ? light.exponent : 0;
  return lamp;
}

Lamp lamp_of(const LuminaireLight& light) {
  Lamp lamp = lamp_of(PointLight{light.position, Intensity(light.colour), {}});
  lamp.table = light.table;
  lamp.axis = light.direction, lamp.c0 = light.c0;
  return lamp;
}

}  // namespace

Lamp lamp(const Light& light) {
  return std::visit([](const auto& l) { return lamp_of(l); }, light);
}

}  // namespace aktina
