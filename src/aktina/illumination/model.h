// The illumination models: plain structs in a variant, resolved outside inner loops.
#pragma once

#include <span>
#include <variant>

#include "aktina/base/method.h"
#include "aktina/illumination/blinn_phong.h"
#include "aktina/illumination/lambert.h"
#include "aktina/illumination/phong.h"

namespace aktina {

using IlluminationModel = std::variant<Lambert, Phong, BlinnPhong>;  // add a model: add it here and in table.cpp

/// BRDF of any model, sr^-1, without the cosine.
/// @param n, wi, wo  unit; wi towards the light, wo towards the viewer, both leaving the surface
inline Reflectance brdf(const IlluminationModel& model, const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) {
  return std::visit([&](const auto& m) { return m.brdf(s, n, wi, wo); }, model);
}

/// Radiance towards wo for a light of classic colour Ip = E / pi, as the literature's lighting equation has it:
/// Ip (kd (n.wi)+ + ks S), S the model's highlight; Ip pi (n.wi)+ brdf for models that are defined by a BRDF. A classic
/// model shines on whatever side of the (interpolated) normal the viewer is.
inline Rgb classic_radiance(const IlluminationModel& model, const Surface& s, Vec3 n, Vec3 wi, Vec3 wo, Rgb ip) {
  const float n_wi = dot(n, wi);
  if (!(n_wi > 0)) return {};
  return std::visit(
      [&](const auto& m) -> Rgb {
        if constexpr (requires { m.highlight(s, n, wi, wo); })
          return ip * (s.kd * n_wi + s.ks * m.highlight(s, n, wi, wo));
        else
          return ip * m.brdf(s, n, wi, wo).total() * (float(kPi) * n_wi);
      },
      model);
}

std::span<const Method<IlluminationModel>* const> illumination_models();

}  // namespace aktina
