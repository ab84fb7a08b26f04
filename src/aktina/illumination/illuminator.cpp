#include "aktina/illumination/illuminator.h"

namespace aktina {

Illuminator::Illuminator(const IlluminationModel& model, const Surface& surface, std::span<const Light> lights,
                         Rgb ambient, const Viewer& viewer)
    : model_(model), surface_(surface), lights_(lights.begin(), lights.end()), ambient_(ambient), viewer_(viewer) {}

void Illuminator::evaluate(const PointArrays& points, const LitArrays& out) const {
  for (size_t i = 0; i < points.count; ++i) {
    Surface surface = surface_;
    if (const SurfaceArrays* s = points.surface) {
      for (int k = 0; k < 3; ++k) {
        if (s->ka[k]) surface.ka[k] = s->ka[k][i];
        if (s->kd[k]) surface.kd[k] = s->kd[k][i];
        if (s->ks[k]) surface.ks[k] = s->ks[k][i];
      }
      if (s->exponent) surface.exponent = s->exponent[i];
    }
    const Point3 x{points.position[0][i], points.position[1][i], points.position[2][i]};
    const Vec3 n{points.normal[0][i], points.normal[1][i], points.normal[2][i]};
    const Lit lit = illuminate(model_, surface, lights_, ambient_, x, normalize_or(n, {0, 0, 1}), viewer_.towards(x));
    for (int k = 0; k < 3; ++k) out.diffuse[k][i] = lit.diffuse[k], out.specular[k][i] = lit.specular[k];
  }
}

}  // namespace aktina
