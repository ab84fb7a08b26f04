#include "aktina/image/tone_map.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace aktina {
namespace {

TEST(AutomaticExposure, MapsAUniformPictureToMiddleGrey) {
  EXPECT_FLOAT_EQ(automatic_exposure(Image(8, 8, 3, 90)), 0.18f / 90);
}

TEST(AutomaticExposure, IsTheGeometricMeanOfWhatIsLit) {
  Image image(4, 1, 3, 0);
  image.set_rgb(0, 0, Rgb(1)), image.set_rgb(1, 0, Rgb(0.25f));
  image.set_rgb(2, 0, Rgb(NAN));  // neither a background nor a broken value counts
  EXPECT_NEAR(automatic_exposure(image), 0.18 / 0.5, 1e-6);
}

TEST(AutomaticExposure, LetsNoMoreThanOnePercentClip) {
  Image image(100, 10, 3, 0.01f);
  for (int i = 0; i < 100; ++i) image.set_rgb(i, 0, Rgb(1));  // a tenth of the picture
  EXPECT_FLOAT_EQ(automatic_exposure(image), 1);
  for (int i = 10; i < 100; ++i) image.set_rgb(i, 0, Rgb(0.01f));  // one percent
  EXPECT_NEAR(automatic_exposure(image), 0.18 / (0.01 * std::pow(100, 0.01)), 1e-3);
}

TEST(AutomaticExposure, OfABlackPictureIsOne) {
  EXPECT_EQ(automatic_exposure(Image(3, 3, 3, 0)), 1);
  EXPECT_EQ(automatic_exposure(Image(3, 3, 3, NAN)), 1);
  EXPECT_EQ(automatic_exposure(Image(3, 3, 3, 1e-42f)), 1) << "no finite exposure";
}

TEST(ToneMap, Curves) {
  EXPECT_EQ(tone_map(Rgb(0.25f), 2, ToneCurve::none), Rgb(0.5f));
  EXPECT_EQ(tone_map(Rgb(1), 1, ToneCurve::reinhard), Rgb(0.5f));
  // Luminance is compressed, colour kept.
  const Rgb red = tone_map({0.6f, 0.3f, 0.3f}, 1, ToneCurve::reinhard);
  EXPECT_NEAR(red.r / red.g, 2, 1e-6);
  EXPECT_NEAR(tone_map(Rgb(1), 1, ToneCurve::filmic).r, 2.54 / 3.16, 1e-6);
}

RC_GTEST_PROP(ToneMap, IsMonotoneAndBounded, ()) {
  const auto curve = *rc::gen::element(ToneCurve::none, ToneCurve::reinhard, ToneCurve::filmic);
  const float a = float(*rc::gen::inRange(0, 100000)) / 1000, b = float(*rc::gen::inRange(0, 100000)) / 1000;
  const float low = tone_map(Rgb(std::min(a, b)), 1, curve).g, high = tone_map(Rgb(std::max(a, b)), 1, curve).g;
  RC_ASSERT(0 <= low && low <= high && high <= 1);
}

TEST(ToneMap, BrokenValuesBecomeBlackOrWhite) {
  for (const ToneCurve curve : {ToneCurve::none, ToneCurve::reinhard, ToneCurve::filmic}) {
    EXPECT_EQ(tone_map(Rgb(NAN), 1, curve), Rgb(0));
    EXPECT_EQ(tone_map(Rgb(-INFINITY), 1, curve), Rgb(0));
    EXPECT_NEAR(tone_map(Rgb(INFINITY), 1, curve).g, 1, 1e-5);
  }
}

}  // namespace
}  // namespace aktina
