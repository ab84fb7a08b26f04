#include "aktina/illumination/model.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

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

TEST(IlluminationModel, ClassicRadianceIsTheBrdfTimesTheIrradiance) {
  const Rgb ip(2, 1, 0.5f);
  EXPECT_TRUE(rc::check([&] {  // L = f E n.wi with E = pi Ip, viewer in front
    const Vec3 n(0, 0, 1);
    const auto direction = [] {
      const float z = 0.01f + 0.99f * float(*rc::gen::inRange(0, 1000)) / 1000,
                  phi = float(*rc::gen::inRange(0, 628)) / 100;
      const float r = std::sqrt(1 - z * z);
      return Vec3(r * std::cos(phi), r * std::sin(phi), z);
    };
    const Vec3 wi = direction(), wo = direction();
    Surface s;
    s.ks = Rgb(0.3f), s.exponent = float(*rc::gen::inRange(0, 200));
    for (const auto* row : illumination_models()) {
      const IlluminationModel model = row->make(ParamSet(row->info));
      const Rgb classic = classic_radiance(model, s, n, wi, wo, ip);
      const Rgb physical = ip * brdf(model, s, n, wi, wo).total() * (float(kPi) * wi.z);
      for (int k = 0; k < 3; ++k) RC_ASSERT(std::abs(classic[k] - physical[k]) <= 1e-5f * (1 + classic[k]));
    }
  }));
}

TEST(IlluminationModel, AClassicHighlightNeedsTheLightInFrontNotTheViewer) {
  const Vec3 n(0, 0, 1), grazing = normalize(Vec3(1, 0, 0.05f)), behind = normalize(Vec3(-1, 0, -0.05f));
  EXPECT_GT(phong_highlight(n, grazing, behind, 2), 0.9f);
  EXPECT_EQ(phong_highlight(n, behind, grazing, 2), 0);
  EXPECT_EQ(blinn_highlight(n, behind, grazing, 2), 0);
}

}  // namespace
}  // namespace aktina
