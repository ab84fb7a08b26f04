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

std::span<const Method<IlluminationModel>* const> illumination_models();

}  // namespace aktina
