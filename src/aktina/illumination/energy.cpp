#include "aktina/illumination/energy.h"

#include <algorithm>
#include <cmath>

namespace aktina {
namespace {

constexpr int kRings = 256, kSpokes = 128;
const Vec3 kNormal(0, 0, 1);

Vec3 direction(float cosine, float phi = 0) {
  const float c = std::clamp(cosine, 1e-4f, 1.0f), s = std::sqrt(1 - c * c);
  return {s * std::cos(phi), s * std::sin(phi), c};
}

/// Integral of value(w) over the hemisphere, by midpoints in polar coordinates about the mirror direction of `given`,
/// each spoke as far as the horizon. Rings crowd at the mirror direction with the fourth power, so that lobes of a few
/// arc minutes are resolved.
template <class Value>
Rgb integrate(Vec3 given, Value value) {
  const Vec3 mirror(-given.x, -given.y, given.z);
  const Frame frame(mirror);
  Vec3d sum(0);
  for (int spoke = 0; spoke < kSpokes; ++spoke) {
    const double phi = 2 * kPi * (spoke + 0.5) / kSpokes;
    const Vec3 out = frame.t * float(std::cos(phi)) + frame.b * float(std::sin(phi));
    const double horizon = std::atan2(double(mirror.z), -double(out.z));
    for (int ring = 0; ring < kRings; ++ring) {
      const double u = (ring + 0.5) / kRings, psi = horizon * u * u * u * u;
      const double area = std::sin(psi) * 4 * horizon * u * u * u / kRings * 2 * kPi / kSpokes;  // sr
      Vec3 w = mirror * float(std::cos(psi)) + out * float(std::sin(psi));
      w.z = std::max(w.z, 1e-6f);
      const Rgb v = value(w);
      sum += Vec3d(v.r, v.g, v.b) * area;
    }
  }
  return {float(sum.x), float(sum.y), float(sum.z)};
}

}  // namespace

Rgb albedo(const IlluminationModel& model, const Surface& surface, float cos_view) {
  const Vec3 wo = direction(cos_view);
  return integrate(wo, [&](Vec3 wi) { return brdf_cosine(model, surface, kNormal, wi, wo).total(); });
}

Rgb reflected_share(const IlluminationModel& model, const Surface& surface, float cos_light) {
  const Vec3 wi = direction(cos_light);
  return integrate(wi, [&](Vec3 wo) { return brdf_cosine(model, surface, kNormal, wi, wo).total() * (wo.z / wi.z); });
}

Reciprocity reciprocity_error(const IlluminationModel& model, const Surface& surface) {
  constexpr int kAngles = 17, kTurns = 12;
  Reciprocity worst{0, kNormal, kNormal};
  for (int i = 0; i <= kAngles; ++i)
    for (int j = 0; j <= i; ++j)
      for (int turn = 0; turn < kTurns; ++turn) {
        const auto cosine = [](int k) { return float(std::cos(k * 5 * kPi / 180)); };
        const Vec3 a = direction(cosine(i)), b = direction(cosine(j), float(turn * kPi / (kTurns - 1)));
        const float there = luminance(brdf(model, surface, kNormal, a, b).total());
        const float back = luminance(brdf(model, surface, kNormal, b, a).total());
        const float most = std::max(there, back);
        const float error = most > 0 ? std::abs(there - back) / most : 0;
        if (error > worst.error) worst = {error, a, b};
      }
  return worst;
}

}  // namespace aktina
