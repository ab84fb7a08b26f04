#include "aktina/illumination/model.h"

#include <gtest/gtest.h>

namespace aktina {
namespace {

TEST(IlluminationModel, NothingIsReflectedBelowTheHorizon) {
  const Vec3 n(0, 0, 1), up = normalize(Vec3(1, 0, 1)), down = normalize(Vec3(1, 0, -0.01f));
  const Surface s;
  for (const auto* row : illumination_models()) {
    const IlluminationModel model = row->make(ParamSet(row->info));
    EXPECT_TRUE(is_black(brdf(model, s, n, down, up).total())) << row->info.id;
    EXPECT_TRUE(is_black(brdf(model, s, n, up, down).total())) << row->info.id;
  }
}

}  // namespace
}  // namespace aktina
