#include "aktina/illumination/energy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aktina {
namespace {

constexpr float kCosines[] = {1, 0.7f, 0.4f, 0.1f};

IlluminationModel model(const char* choice) { return make_method(illumination_models(), "illumination", choice); }

Surface white() {
  Surface s;
  s.kd = Rgb(0.8f, 0.5f, 0.2f), s.ks = Rgb(0);
  return s;
}

TEST(Energy, LambertReflectsItsCoefficientAtEveryAngle) {
  for (const float c : kCosines) {
    const Rgb seen = albedo(model("lambert"), white(), c), sent = reflected_share(model("lambert"), white(), c);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(seen[k], white().kd[k], 2e-3f);
      EXPECT_NEAR(sent[k], white().kd[k], 2e-3f);
    }
  }
}

TEST(Energy, PhongsLobeAlongTheNormalHasItsClosedForm) {
  // ks / pi times the integral of cos^n over the hemisphere: 2 ks / (n + 1), seen along the normal
  for (const float n : {0.0f, 1.0f, 10.0f, 100.0f, 1e4f}) {
    Surface s;
    s.kd = Rgb(0), s.ks = Rgb(1), s.exponent = n;
    EXPECT_NEAR(albedo(model("phong"), s, 1).g, 2 / (n + 1), 2e-3f * 2 / (n + 1)) << n;
    EXPECT_NEAR(reflected_share(model("phong"), s, 1).g, 2 / (n + 2), 2e-3f * 2 / (n + 2)) << n;
  }
}

TEST(Energy, OrenNayarLosesWhatItsHeaderSays) {
  Surface s;
  s.kd = Rgb(1);
  // along the normal f is A / pi = (1 - 0.5 s^2 / (s^2 + 0.33)) / pi, and less than elsewhere
  EXPECT_NEAR(albedo(model("oren_nayar:sigma=0.5"), s, 1).g, 1 - 0.125f / 0.58f, 1e-3f);
  for (const float c : kCosines) EXPECT_GE(albedo(model("oren_nayar:sigma=0.5"), s, c).g, 0.784f) << c;
  EXPECT_NEAR(albedo(model("oren_nayar:sigma=0"), s, 0.5f).g, 1, 2e-3f);
}

TEST(Energy, ReciprocalModelsSendWhatTheySee) {
  Surface s;
  s.kd = Rgb(0.3f), s.ks = Rgb(0.5f), s.exponent = 20, s.roughness = 0.5f;
  for (const char* choice : {"lambert", "oren_nayar", "cook_torrance", "torrance_sparrow", "ward", "ggx"}) {
    EXPECT_LT(reciprocity_error(model(choice), s).error, 2e-3f) << choice;
    for (const float c : {1.0f, 0.7f, 0.4f})
      EXPECT_NEAR(albedo(model(choice), s, c).g, reflected_share(model(choice), s, c).g, 1e-2f) << choice << c;
  }
}

TEST(Energy, ClassicHighlightsAreNotReciprocal) {
  // f = ks S / (pi n.wi) with a symmetric S: exchanged, it is off by the ratio of the cosines
  Surface s;
  s.kd = Rgb(0), s.ks = Rgb(0.5f), s.exponent = 1;
  for (const char* choice : {"phong", "blinn_phong", "schlick"}) {
    const Reciprocity worst = reciprocity_error(model(choice), s);
    EXPECT_NEAR(worst.error, 1 - worst.a.z / worst.b.z, 1e-3f) << choice;
    EXPECT_GT(worst.error, 0.8f) << choice;
  }
}

TEST(Energy, EveryModelHasAFiniteAlbedo) {
  for (const auto* row : illumination_models())
    for (const float exponent : {0.0f, -3.0f, 1e6f})
      for (const float c : {1.0f, 0.01f, 0.0f}) {
        Surface s;
        s.ks = Rgb(1), s.exponent = exponent;
        EXPECT_TRUE(is_finite(albedo(row->make(ParamSet(row->info)), s, c))) << row->info.id << exponent << c;
      }
}

}  // namespace
}  // namespace aktina
