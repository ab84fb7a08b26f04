#include "aktina/raster/shading/highlight_form.h"

namespace aktina {

ShadingPlan plan_of_highlights() {
  return {.kind = ShadingPlan::Kind::spans,
          .needs = ShadingPlan::kPosition | ShadingPlan::kNormal | ShadingPlan::kRadiance | ShadingPlan::kScreen};
}

std::vector<float> fall_recurrence(const PlaceForm& form, float b1, float b2, float step1, float step2, int count) {
  const Vec3 along1 = form.corner[1] - form.corner[0], along2 = form.corner[2] - form.corner[0];
  Vec3 place = form.corner[0] + b1 * along1 + b2 * along2;
  const Vec3 step = step1 * along1 + step2 * along2;
  std::vector<float> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(place.z > 0 ? place.x * place.x + place.y * place.y : 1);
    place += step;
  }
  return out;
}

std::vector<float> fall_recurrence(const QuadraticForm& form, float b1, float b2, float step1, float step2, int count) {
  const auto& c = form.coefficient;
  const float second = c[3] * step1 * step1 + c[4] * step1 * step2 + c[5] * step2 * step2;
  float u = c[0] + c[1] * b1 + c[2] * b2 + c[3] * b1 * b1 + c[4] * b1 * b2 + c[5] * b2 * b2;
  float du = (c[1] + 2 * c[3] * b1 + c[4] * b2) * step1 + (c[2] + c[4] * b1 + 2 * c[5] * b2) * step2 + second;
  std::vector<float> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(u);
    u += du, du += 2 * second;
  }
  return out;
}

}  // namespace aktina
