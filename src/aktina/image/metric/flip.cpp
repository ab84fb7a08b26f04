// FLIP: the difference that a viewer sees when two pictures alternate. Colours are filtered as the eye's contrast
// sensitivity does it at the given distance, and compared in a perceptual space; where edges or points differ, the
// colour difference is raised.
//
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/image/metric/flip_colour.h"
#include "aktina/image/metric/metrics.h"

namespace aktina {
namespace {

using flip::Triple;

constexpr double kPi = std::numbers::pi;
constexpr size_t kGrain = 1 << 13;  // pixels

/// Contrast sensitivity, section 4.1, table 1: sums of a_i sqrt(pi / b_i) exp(-pi^2 d^2 / b_i), d in degrees.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic = {1, 0.0047, 0, 1e-5};
constexpr Sensitivity kRedGreen = {1, 0.0053, 0, 1e-5};
constexpr Sensitivity kBlueYellow = {34.1, 0.04, 13.5, 0.025};
constexpr double kWidest = 0.04;

// Section 4.1.3 and 4.2: exponents, the knee of the colour error, and the width of a feature in degrees.
constexpr float kColourExponent = 0.7f, kKnee = 0.4f, kKneeValue = 0.95f, kFeatureExponent = 0.5f;
constexpr double kFeatureWidth = 0.082;

/// Each term is a separable Gaussian; the terms are weighted so that the whole filter sums to 1.
Image filter_sensitivity(const Image& channel, const Sensitivity& s, double pixels_per_degree) {
  const int radius = int(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixels_per_degree));
  const auto sigma = [&](double b) { return std::sqrt(b / (2 * kPi * kPi)) * pixels_per_degree; };
  const auto volume = [&](double a, double b) {  // of one term over the kernel's square
    double sum = 0;
    for (int x = -radius; x <= radius; ++x) sum += std::exp(-0.5 * x * x / (sigma(b) * sigma(b)));
    return a * std::sqrt(kPi / b) * sum * sum;
  };
  const std::vector<float> first = gaussian_kernel(sigma(s.b1), radius);
  Image out = filter_separable(channel, first, first);
  if (s.a2 == 0) return out;
  const std::vector<float> second = gaussian_kernel(sigma(s.b2), radius);
  const Image other = filter_separable(channel, second, second);
  const double total = volume(s.a1, s.b1) + volume(s.a2, s.b2);
  const auto w1 = float(volume(s.a1, s.b1) / total), w2 = float(volume(s.a2, s.b2) / total);
  for (size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = w1 * out.pixels[i] + w2 * other.pixels[i];
  return out;
}

/// Three planes of one picture.
struct Planes {
  Image x, y, z;
  Planes(int width, int height) : x(width, height, 1), y(width, height, 1), z(width, height, 1) {}
  Triple get(size_t i) const { return {x.pixels[i], y.pixels[i], z.pixels[i]}; }
  void set(size_t i, Triple t) { x.pixels[i] = t.x, y.pixels[i] = t.y, z.pixels[i] = t.z; }
};

template <class Body>
void for_each_pixel(const Image& image, Body body) {
  parallel_for(size_t(image.width) * size_t(image.height), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) body(i);
  });
}

Planes opponent_colours(const Image& picture) {
  Planes planes(picture.width, picture.height);
  for_each_pixel(picture, [&](size_t i) {
    const float* const p = &picture.pixels[i * size_t(picture.channels)];
    const Rgb c = picture.channels >= 3 ? Rgb{p[0], p[1], p[2]} : Rgb(p[0]);
    planes.set(i, flip::ycxcz(clamped(c, 0, 1)));
  });
  return planes;
}

/// What the eye resolves, in Hunt-adjusted L*a*b*.
Planes seen(const Planes& opponent, double pixels_per_degree) {
  Planes out(opponent.x.width, opponent.x.height);
  const Image y = filter_sensitivity(opponent.x, kAchromatic, pixels_per_degree);
  const Image cx = filter_sensitivity(opponent.y, kRedGreen, pixels_per_degree);
  const Image cz = filter_sensitivity(opponent.z, kBlueYellow, pixels_per_degree);
  for_each_pixel(y, [&](size_t i) {
    const Rgb c = flip::rgb_of_ycxcz({y.pixels[i], cx.pixels[i], cz.pixels[i]});
    out.set(i, flip::hunt_lab(clamped(c, 0, 1)));
  });
  return out;
}

/// First and second derivatives of a Gaussian; positive and negative weights sum to 1 and to -1.
std::vector<float> derivative_kernel(double sigma, int radius, bool second) {
  std::vector<double> exact;
  double positive = 0, negative = 0;
  for (int x = -radius; x <= radius; ++x) {
    const double g = std::exp(-0.5 * x * x / (sigma * sigma));
    const double value = exact.emplace_back(second ? (x * x / (sigma * sigma) - 1) * g : -x * g);
    (value > 0 ? positive : negative) += std::abs(value);
  }
  std::vector<float> kernel;
  for (const double value : exact) kernel.push_back(float(value / (value > 0 ? positive : negative)));
  return kernel;
}

struct Features {
  Image edges, points;
};

Image magnitude(const Image& a, const Image& b) {
  Image out(a.width, a.height, 1);
  for_each_pixel(out,
                 [&](size_t i) { out.pixels[i] = std::sqrt(a.pixels[i] * a.pixels[i] + b.pixels[i] * b.pixels[i]); });
  return out;
}

/// Of the achromatic channel, scaled to [0, 1].
Features features(const Image& achromatic, double pixels_per_degree) {
  Image y = achromatic;
  for (float& value : y.pixels) value = (value + 16) / 116;
  const double sigma = 0.5 * kFeatureWidth * pixels_per_degree;
  const int radius = int(std::ceil(3 * sigma));
  const std::vector<float> smooth = gaussian_kernel(sigma, radius);
  const auto detect = [&](bool second) {
    const std::vector<float> kernel = derivative_kernel(sigma, radius, second);
    return magnitude(filter_separable(y, kernel, smooth), filter_separable(y, smooth, kernel));
  };
  return {detect(false), detect(true)};
}

/// The largest colour error there is, between green and blue.
float largest_colour_error() {
  return std::pow(flip::hyab(flip::hunt_lab({0, 1, 0}), flip::hunt_lab({0, 0, 1})), kColourExponent);
}

/// To [0, 1]: most of the range for the errors below the knee.
float redistributed(float error, float largest) {
  const float knee = kKnee * largest;
  if (error < knee) return kKneeValue * error / knee;
  return std::min(1.0f, kKneeValue + (error - knee) / (largest - knee) * (1 - kKneeValue));
}

}  // namespace

Image flip_map(const Image& picture, const Image& reference, double pixels_per_degree) {
  if (picture.width != reference.width || picture.height != reference.height)
    throw Error(Code::usage, "flip", "the pictures differ in size");
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
    throw Error(Code::bad_param, "flip.pixels_per_degree", "out of range", "accepted 1 .. 1000");
  const Planes a = opponent_colours(picture), b = opponent_colours(reference);
  const Planes seen_a = seen(a, pixels_per_degree), seen_b = seen(b, pixels_per_degree);
  const Features features_a = features(a.x, pixels_per_degree), features_b = features(b.x, pixels_per_degree);
  const float largest = largest_colour_error();
  Image map(picture.width, picture.height, 1);
  for_each_pixel(map, [&](size_t i) {
    const float colour = redistributed(std::pow(flip::hyab(seen_a.get(i), seen_b.get(i)), kColourExponent), largest);
    const float edge = std::abs(features_a.edges.pixels[i] - features_b.edges.pixels[i]);
    const float point = std::abs(features_a.points.pixels[i] - features_b.points.pixels[i]);
    const float feature = std::pow(std::max(edge, point) * float(1 / std::numbers::sqrt2), kFeatureExponent);
    map.pixels[i] = std::pow(colour, 1 - std::min(feature, 1.0f));
  });
  return map;
}

}  // namespace aktina
