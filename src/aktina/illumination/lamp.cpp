#include "aktina/illumination/lamp.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  lamp.outer_cosine = outer > -1 ? outer : -2;  // a cone of 180 degrees leaves nothing out, rounded or not
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

Lamp lamp_of(const WarnLight& light) {
  Lamp lamp = lamp_of(PointLight{light.position, light.intensity, light.attenuation});
  lamp.cone = true;
  lamp.axis = light.direction;
  lamp.outer_cosine = std::max(std::cos(light.cone_angle), std::numeric_limits<float>::min());
  lamp.ramp_offset = 1;
  lamp.exponent = light.exponent > 0 ? light.exponent : 0;
  lamp.flaps = true, lamp.flap_low = light.flap_low, lamp.flap_high = light.flap_high;
  return lamp;
}

Lamp lamp_of(const RectangleLight& light) {
  Lamp lamp{};
  lamp.shape = LampShape::rectangle;
  lamp.place = light.corner, lamp.edge_u = light.edge_u, lamp.edge_v = light.edge_v;
  lamp.axis = normalize_or(cross(light.edge_u, light.edge_v), Vec3(0));
  lamp.colour = light.radiance.v * float(kInvPi);
  lamp.both_sides = light.both_sides;
  return lamp;
}

Lamp lamp_of(const DiscLight& light) {
  Lamp lamp{};
  lamp.shape = LampShape::disc;
  lamp.place = light.position, lamp.axis = light.direction, lamp.radius = light.radius;
  lamp.colour = light.radiance.v * float(kInvPi);
  lamp.both_sides = light.both_sides;
  return lamp;
}

}  // namespace

Lamp lamp(const Light& light) {
  return std::visit([](const auto& l) { return lamp_of(l); }, light);
}

}  // namespace aktina
