// Metrics of difference: closed forms, symmetries, and what their papers say of them.
#include "aktina/image/metric.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/image/metric/metrics.h"
#include "image/pictures.h"

namespace aktina {
namespace {

using test::noise;

Image uniform(Rgb colour, int width = 32, int height = 24) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.set_rgb(x, y, colour);
  return image;
}

/// A bright square on a dark ground.
Image square(int at, float value = 0.9f) {
  Image image = uniform(Rgb(0.1f), 64, 64);
  for (int y = 20; y < 40; ++y)
    for (int x = at; x < at + 20; ++x) image.set_rgb(x, y, Rgb(value));
  return image;
}

double mean(const Image& map) {
  double sum = 0;
  for (const float v : map.pixels) sum += v;
  return sum / double(map.pixels.size());
}

TEST(Compare, EqualPictures) {
  for (const float top : {1.0f, 1000.0f}) {
    const Image image = noise(33, 21, 3, top);
    const ImageComparison c = compare(image, image);
    EXPECT_EQ(c.rmse, 0);
    EXPECT_EQ(c.max_error, 0);
    EXPECT_EQ(c.relative_mse, 0);
    EXPECT_EQ(c.flip, 0);
    EXPECT_NEAR(c.ssim, 1, 1e-9);
    EXPECT_TRUE(std::isinf(c.psnr));
    EXPECT_EQ(c.flip_hdr, top > 1);
  }
}

TEST(Compare, UniformShift) {
  const ImageComparison c = compare(uniform(Rgb(0.6f)), uniform(Rgb(0.5f)));
  EXPECT_NEAR(c.rmse, 0.1, 1e-6);
  EXPECT_NEAR(c.max_error, 0.1, 1e-6);
  EXPECT_NEAR(c.psnr, 20, 1e-4);
  EXPECT_NEAR(c.relative_mse, 0.01 / 0.26, 1e-6);
}

TEST(Compare, PeakOfAnHdrPictureIsTheReferencesLargestValue) {
  const ImageComparison c = compare(uniform(Rgb(60)), uniform(Rgb(50)));
  EXPECT_NEAR(c.psnr, 20 * std::log10(5), 1e-6);
  EXPECT_TRUE(c.flip_hdr);
}

TEST(Compare, OneWrongValue) {
  Image a = noise(40, 30, 3);
  a.at(3, 4)[1] = 0.25f;
  Image b = a;
  b.at(3, 4)[1] = 0.75f;
  const ImageComparison c = compare(a, b);
  EXPECT_FLOAT_EQ(float(c.max_error), 0.5f);
  EXPECT_NEAR(c.rmse, 0.5 / std::sqrt(40 * 30 * 3), 1e-7);
}

TEST(Compare, LowRangeClips) {
  const ImageComparison c = compare(uniform(Rgb(7)), uniform(Rgb(1)), DynamicRange::low);
  EXPECT_EQ(c.max_error, 0);
  EXPECT_EQ(c.flip, 0);
}

TEST(Compare, CountsWhatIsNoNumber) {
  Image a = uniform(Rgb(0.5f)), b = a;
  a.at(0, 0)[0] = NAN, a.at(1, 0)[2] = -INFINITY, b.at(2, 0)[0] = INFINITY;
  const ImageComparison c = compare(a, b);
  EXPECT_EQ(c.non_finite_a, 2u);
  EXPECT_EQ(c.non_finite_b, 1u);
  EXPECT_FLOAT_EQ(float(c.max_error), 0.5f) << "taken as 0";
  EXPECT_TRUE(std::isfinite(c.flip) && std::isfinite(c.ssim));
}

TEST(Compare, RefusesOtherSizes) {
  EXPECT_THROW(compare(uniform(Rgb(0), 3, 4), uniform(Rgb(0), 4, 3)), Error);
  EXPECT_THROW(compare(Image(), Image()), Error);
}

TEST(Compare, IsTheSameForAnyNumberOfThreads) {
  const Image a = noise(301, 97, 3, 3, 1), b = noise(301, 97, 3, 3, 2);
  set_thread_count(1);
  const ImageComparison one = compare(a, b);
  set_thread_count(3);
  const ImageComparison three = compare(a, b);
  set_thread_count(0);
  EXPECT_EQ(one.rmse, three.rmse);
  EXPECT_EQ(one.ssim, three.ssim);
  EXPECT_EQ(one.flip, three.flip);
}

// SSIM
// -----------------------------------------------------------------------------------------------------------------

Image grey(float value) { return Image(40, 30, 1, value); }

/// Without variance only the luminance term is left: (2 a b + C1) / (a^2 + b^2 + C1). Variances are differences of
/// floats near 0.6, so up to 1e-7 off, to be seen beside C2 = 9e-4.
TEST(Ssim, OfUniformPictures) {
  EXPECT_NEAR(structural_similarity(grey(0.2f), grey(0.8f), 1), (2 * 0.16 + 1e-4) / (0.68 + 1e-4), 2e-7 / 9e-4);
  EXPECT_NEAR(structural_similarity(grey(51), grey(204), 255), (2 * 0.16 + 1e-4) / (0.68 + 1e-4), 2e-7 / 9e-4);
}

TEST(Ssim, OfANegativeIsNegative) {
  const Image image = noise(40, 30, 1);
  Image negative = image;
  for (float& v : negative.pixels) v = 1 - v;
  EXPECT_LT(structural_similarity(image, negative, 1), -0.5);
}

RC_GTEST_PROP(Ssim, IsSymmetricAndAtMostOne, (uint32_t seed)) {
  const Image a = noise(1 + int(seed % 20), 14, 1, 1, seed), b = noise(a.width, 14, 1, 1, seed + 1);
  const double ab = structural_similarity(a, b, 1);
  RC_ASSERT(ab <= 1 && ab >= -1);
  RC_ASSERT(std::abs(ab - structural_similarity(b, a, 1)) < 1e-9);
}

// FLIP
// -----------------------------------------------------------------------------------------------------------------

/// Uniform pictures have no features and pass the filters unchanged: only the colour term is left. Black and white lie
/// 100 apart in L*; the largest error, of green and blue, follows from CIE L*a*b* of sRGB's primaries.
TEST(Flip, BlackAgainstWhiteInClosedForm) {
  const auto hunt = [](double l, double a, double b) { return std::array{l, 0.01 * l * a, 0.01 * l * b}; };
  const auto green = hunt(87.7370, -86.1846, 83.1812), blue = hunt(32.3026, 79.1967, -107.8637);  // Lindbloom, D65
  const double largest = std::pow(green[0] - blue[0] + std::hypot(green[1] - blue[1], green[2] - blue[2]), 0.7);
  const double knee = 0.4 * largest, error = std::pow(100, 0.7);
  const double expected = 0.95 + 0.05 * (error - knee) / (largest - knee);
  EXPECT_NEAR(mean(flip_map(uniform(Rgb(0)), uniform(Rgb(1)))), expected, 1e-3);
  EXPECT_NEAR(mean(flip_map(uniform({0, 1, 0}), uniform({0, 0, 1}))), 1, 1e-4) << "the largest error there is";
}

TEST(Flip, IsSymmetricWithin0And1) {
  const Image a = noise(50, 40, 3, 1, 1), b = noise(50, 40, 3, 1, 2);
  const Image ab = flip_map(a, b);
  EXPECT_EQ(ab.pixels, flip_map(b, a).pixels);
  for (const float v : ab.pixels) ASSERT_TRUE(v >= 0 && v <= 1);
}

/// Noise is averaged away by the eye at a distance.
TEST(Flip, SmallDetailsFadeWithDistance) {
  const Image a = noise(128, 128, 3, 1, 1), b = noise(128, 128, 3, 1, 2);
  EXPECT_LT(mean(flip_map(a, b, 120)), 0.8 * mean(flip_map(a, b, 30)));
}

TEST(Flip, AMovedEdgeIsSeenWhereItIs) {
  const Image map = flip_map(square(22), square(20));
  EXPECT_GT(*map.at(20, 30), 0.5f);
  EXPECT_GT(*map.at(41, 30), 0.5f);
  EXPECT_LT(*map.at(5, 5), 1e-3f);
}

TEST(Flip, GrowsWithTheDifference) {
  double last = 0;
  for (const float value : {0.85f, 0.7f, 0.5f, 0.3f}) {
    const double now = mean(flip_map(square(20, value), square(20)));
    EXPECT_GT(now, last) << value;
    last = now;
  }
}

/// A reference of one value is seen at the exposure that shows it as 0.85: one comparison in low range.
TEST(FlipHdr, OfAUniformReferenceIsOneExposure) {
  const auto curve = [](double x) {
    return std::min(1.0, x * (0.9036 * x + 0.018) / (x * (0.8748 * x + 0.354) + 0.14));
  };
  double low = 0, high = 10;
  for (int i = 0; i < 60; ++i) (curve((low + high) / 2) < 0.85 ? low : high) = (low + high) / 2;
  const double expected = mean(flip_map(uniform(Rgb(float(curve(low / 2)))), uniform(Rgb(0.85f))));
  EXPECT_NEAR(mean(flip_map_hdr(uniform(Rgb(500)), uniform(Rgb(1000)))), expected, 1e-4);
}

TEST(FlipHdr, DoesNotDependOnTheUnit) {
  const Image a = noise(40, 40, 3, 50, 1), b = noise(40, 40, 3, 50, 2);
  Image a2 = a, b2 = b;
  for (float& v : a2.pixels) v *= 1024;
  for (float& v : b2.pixels) v *= 1024;
  EXPECT_NEAR(mean(flip_map_hdr(a, b)), mean(flip_map_hdr(a2, b2)), 1e-5);
}

/// The paper's point: what a tone-mapped picture clips is still seen at another exposure.
TEST(FlipHdr, SeesDifferencesInBrightPartsThatLowRangeClips) {
  const Image a = square(20, 100), b = square(20, 400);
  EXPECT_EQ(compare(a, b, DynamicRange::low).flip, 0);
  EXPECT_GT(compare(a, b, DynamicRange::high).flip, 0.02);
}

TEST(FlipHdr, OfBlackPictures) {
  EXPECT_EQ(mean(flip_map_hdr(uniform(Rgb(0)), uniform(Rgb(0)))), 0);
  EXPECT_GT(mean(flip_map_hdr(uniform(Rgb(1)), uniform(Rgb(0)))), 0.5);
}

TEST(Flip, RefusesWhatItCannotCompare) {
  EXPECT_THROW(flip_map(uniform(Rgb(0), 3, 4), uniform(Rgb(0), 4, 3)), Error);
  EXPECT_THROW(flip_map(uniform(Rgb(0)), uniform(Rgb(0)), 0), Error);
  EXPECT_THROW(flip_map(uniform(Rgb(0)), uniform(Rgb(0)), NAN), Error);
}

// Parts
// ----------------------------------------------------------------------------------------------------------------

TEST(SeparableFilter, SpreadsAPointAsTheKernelSays) {
  Image point(40, 9, 1);
  *point.at(20, 4) = 1;
  const std::vector<float> x = {1, 2, 3}, y = {5, 0, 7};
  const Image out = filter_separable(point, x, y);
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 40; ++i) {
      const bool near = std::abs(i - 20) <= 1 && std::abs(j - 4) <= 1;
      EXPECT_EQ(*out.at(i, j), near ? x[size_t(21 - i)] * y[size_t(5 - j)] : 0) << i << " " << j;
    }
}

TEST(SeparableFilter, BordersGoOn) {
  const std::vector<float> kernel = gaussian_kernel(2, 6);
  for (const int width : {1, 5, 16, 37})
    for (const float v : filter_separable(Image(width, 3, 1, 0.75f), kernel, kernel).pixels)
      EXPECT_NEAR(v, 0.75f, 1e-6f);
}

TEST(FalseColour, RisesInLuminanceFromBlack) {
  Image map(101, 1, 1);
  for (int i = 0; i <= 100; ++i) *map.at(i, 0) = float(i) / 100;
  const Image colours = false_colour(map);
  EXPECT_LT(luminance(colours.rgb(0, 0)), 1e-3f);
  EXPECT_GT(luminance(colours.rgb(100, 0)), 0.9f);
  for (int i = 0; i < 100; ++i) EXPECT_LT(luminance(colours.rgb(i, 0)), luminance(colours.rgb(i + 1, 0))) << i;
  Image odd(3, 1, 1);
  odd.pixels = {NAN, -1, 2};
  EXPECT_EQ(false_colour(odd).rgb(0, 0), colours.rgb(0, 0));
  EXPECT_EQ(false_colour(odd).rgb(1, 0), colours.rgb(0, 0));
  EXPECT_EQ(false_colour(odd).rgb(2, 0), colours.rgb(100, 0));
}

}  // namespace
}  // namespace aktina
