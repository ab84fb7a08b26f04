// Light sources as plain structs: what arrives at a point, from where.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <variant>

#include "aktina/base/method.h"
#include "aktina/base/quantity.h"
#include "aktina/base/vec.h"
#include "aktina/illumination/light/attenuation.h"
#include "aktina/illumination/light/photometric_table.h"

namespace aktina {

struct LightSample {
  Vec3 wi;            // unit, from the shaded point towards the light
  float distance;     // m; the shadow ray ends here, on the light; kInfinity for a light at infinity
  Irradiance e_perp;  // on a plane facing wi: I/d^2 for a point, L/pdf for an area (pdf in sr^-1)
};

/// A point that shines equally in all directions. Flux 4 pi I.
struct PointLight {
  Point3 position{0};
  Intensity intensity{Rgb(1)};
  Attenuation attenuation{};
};

/// A point light that shines within a cone about `direction`, as KHR_lights_punctual (smooth cone) or
/// as the classic hard cone with exponent.
struct SpotLight {
  Point3 position{0};
  Vec3 direction{0, 0, -1};  // unit, out of the lamp
  Intensity intensity{Rgb(1)};
  float inner_angle = 0, outer_angle = 0.785398f;  // rad, from the axis; smooth between them
  float exponent = 0;                              // cos^exponent inside the cone; 0: none
  Attenuation attenuation{};
};

/// Parallel light from far away.
struct DirectionalLight {
  Vec3 direction{0, 0, -1};   // unit, the way the light travels
  Irradiance e_perp{Rgb(1)};  // lx on a plane facing the light
};

/// A point with a measured intensity for each direction. Untransformed it shines as EXT_lights_ies has it: gamma = 0
/// towards -z, gamma = 90 in plane C0 towards +x, in plane C90 towards +y.
struct LuminaireLight {
  Point3 position{0};
  Vec3 direction{0, 0, -1};                       // unit; gamma = 0
  Vec3 c0{1, 0, 0};                               // unit, at right angles to `direction`: gamma = 90 in plane C0
  Rgb colour{1};                                  // times the table
  std::shared_ptr<const PhotometricTable> table;  // cd; none: 1 cd in all directions
};

/// Warn's studio lamp: cos^exponent off its axis, cut by a cone and by flaps, planes across the world's axes.
struct WarnLight {
  static constexpr float kNoFlap = 1e30f;  // m
  Point3 position{0};
  Vec3 direction{0, 0, -1};  // unit, out of the lamp
  Intensity intensity{Rgb(1)};
  float exponent = 1;                             // of the cosine off the axis; nothing shines backwards
  float cone_angle = float(kPi);                  // rad, from the axis: dark beyond
  Point3 flap_low{-kNoFlap}, flap_high{kNoFlap};  // m, world: points outside of this box are not lit
  Attenuation attenuation{};
};

/// A parallelogram that shines evenly as Lambert's cosine has it: from its front, towards edge_u x edge_v. In a scene
/// it stands as a surface: place_light().
struct RectangleLight {
  Point3 corner{-0.5f, -0.5f, 0};
  Vec3 edge_u{0, 1, 0}, edge_v{1, 0, 0};  // m
  Radiance radiance{Rgb(1)};
  bool both_sides = false;
};

/// A disc that shines the same way.
struct DiscLight {
  Point3 position{0};
  Vec3 direction{0, 0, -1};  // unit, out of the front
  float radius = 0.5f;       // m
  Radiance radiance{Rgb(1)};
  bool both_sides = false;
};

using Light = std::variant<PointLight, SpotLight, DirectionalLight, LuminaireLight, WarnLight, RectangleLight,
                           DiscLight>;  // add a light: add it here and in table.cpp

LightSample sample(const PointLight& light, Point3 x);
LightSample sample(const SpotLight& light, Point3 x);
LightSample sample(const DirectionalLight& light, Point3 x);
LightSample sample(const LuminaireLight& light, Point3 x);
LightSample sample(const WarnLight& light, Point3 x);
LightSample sample(const RectangleLight& light, Point3 x);
LightSample sample(const DiscLight& light, Point3 x);
inline LightSample sample(const Light& light, Point3 x) {
  return std::visit([&](const auto& l) { return sample(l, x); }, light);
}

/// Total luminous flux, lm; none for a light at infinity.
std::optional<Flux> flux(const PointLight& light);
std::optional<Flux> flux(const SpotLight& light);
std::optional<Flux> flux(const DirectionalLight& light);
std::optional<Flux> flux(const LuminaireLight& light);
std::optional<Flux> flux(const WarnLight& light);
std::optional<Flux> flux(const RectangleLight& light);
std::optional<Flux> flux(const DiscLight& light);
inline std::optional<Flux> flux(const Light& light) {
  return std::visit([](const auto& l) { return flux(l); }, light);
}

/// Factor in [0, 1] of a spot at angle acos(c) off its axis.
float spot_falloff(const SpotLight& light, float c);

/// Light on surfaces from a lamp with an area, as one vector: its length is E on a plane that faces it, its direction
/// the mean one of the light, so that the irradiance of any surface that has the whole lamp above its horizon is
/// exactly its dot product with the normal.
LightSample vector_sample(Vec3d irradiance, Rgb radiance, double distance);

std::span<const Method<Light>* const> lights();

}  // namespace aktina
