// The illumination models: plain structs in a variant, resolved outside inner loops.
#pragma once

#include <algorithm>
#include <span>
#include <variant>

#include "aktina/base/method.h"
#include "aktina/illumination/ambient.h"
#include "aktina/illumination/blinn_phong.h"
#include "aktina/illumination/constant.h"
#include "aktina/illumination/cook_torrance.h"
#include "aktina/illumination/ggx.h"
#include "aktina/illumination/lambert.h"
#include "aktina/illumination/oren_nayar.h"
#include "aktina/illumination/phong.h"
#include "aktina/illumination/schlick.h"
#include "aktina/illumination/torrance_sparrow.h"
#include "aktina/illumination/ward.h"

namespace aktina {

using IlluminationModel =
    std::variant<Constant, Ambient, Lambert, OrenNayar, Phong, BlinnPhong, Schlick, TorranceSparrow, CookTorrance, Ward,
                 Ggx>;  // add a model: add it here and in table.cpp

/// BRDF of any model, sr^-1, without the cosine.
/// @param n, wi, wo  unit; wi towards the light, wo towards the viewer, both leaving the surface
inline Reflectance brdf(const IlluminationModel& model, const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) {
  return std::visit([&](const auto& m) { return m.brdf(s, n, wi, wo); }, model);
}

/// f times the cosine of the light, (n.wi)+, apart by lobe, sr^-1: what the lighting equation sums up. Models with a
/// highlight S of the literature give (kd n.wi + ks S) / pi, on whatever side of the (interpolated) normal the viewer
/// is; constant lighting does not ask where the light is; models that are defined by a BRDF give that.
inline Reflectance brdf_cosine(const IlluminationModel& model, const Surface& s, Vec3 n, Vec3 wi, Vec3 wo) {
  if (std::holds_alternative<Constant>(model)) return {s.kd * (std::max(dot(n, wo), 0.0f) * float(kInvPi)), Rgb()};
  const float n_wi = dot(n, wi);
  if (!(n_wi > 0)) return {};
  return std::visit(
      [&](const auto& m) -> Reflectance {
        if constexpr (requires { m.highlight(s, n, wi, wo); }) {
          return {s.kd * (n_wi * float(kInvPi)), s.ks * (m.highlight(s, n, wi, wo) * float(kInvPi))};
        } else {
          const Reflectance f = m.brdf(s, n, wi, wo);
          return {f.diffuse * n_wi, f.specular * n_wi};
        }
      },
      model);
}

/// Radiance towards wo for a light of classic colour Ip = E / pi: Ip (kd (n.wi)+ + ks S).
inline Rgb classic_radiance(const IlluminationModel& model, const Surface& s, Vec3 n, Vec3 wi, Vec3 wo, Rgb ip) {
  return ip * brdf_cosine(model, s, n, wi, wo).total() * float(kPi);
}

std::span<const Method<IlluminationModel>* const> illumination_models();

}  // namespace aktina
