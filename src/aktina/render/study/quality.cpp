#include "aktina/render/study/quality.h"

#include <algorithm>
#include <cmath>

#include "aktina/base/statistics.h"
#include "aktina/image/metric.h"

namespace aktina {
namespace {

constexpr float kHighlight = 0.05f;  // of white

float luminance_at(const Image& image, size_t pixel) {
  const float* p = &image.pixels[pixel * size_t(image.channels)];
  return luminance({p[0], p[1], p[2]});
}

}  // namespace

Image exposed(const Image& picture, float exposure) {
  Image out(picture.width, picture.height, 3);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      Rgb c = picture.rgb(x, y) * exposure;
      for (int k = 0; k < 3; ++k) c[k] = std::isfinite(c[k]) ? c[k] : 0;
      out.set_rgb(x, y, c);
    }
  return out;
}

Quality compare_pictures(const Image& picture, const Image& reference, float exposure) {
  Quality q;
  for (const float value : picture.pixels) q.not_finite += !std::isfinite(value);
  const Image a = exposed(picture, exposure), b = exposed(reference, exposure);
  Sum squared;
  q.max_error = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = double(a.pixels[i]) - double(b.pixels[i]);
    squared.add(difference * difference);
    q.max_error = std::max(q.max_error, std::abs(difference));
  }
  q.rmse = std::sqrt(squared.value() / double(a.pixels.size()));
  const ImageComparison shown = compare(a, b, DynamicRange::low);
  q.psnr = shown.psnr, q.flip = shown.flip;
  return q;
}

Image highlight_mask(const Image& shiny, const Image& matt, float exposure) {
  Image mask(shiny.width, shiny.height, 1);
  const Image a = exposed(shiny, exposure), b = exposed(matt, exposure);
  for (size_t i = 0; i < mask.pixels.size(); ++i) mask.pixels[i] = luminance_at(a, i) - luminance_at(b, i) > kHighlight;
  return mask;
}

double masked_rmse(const Image& picture, const Image& reference, const Image& mask, float exposure) {
  const Image a = exposed(picture, exposure), b = exposed(reference, exposure);
  Sum squared;
  size_t count = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    if (mask.pixels[i / 3] == 0) continue;
    const double difference = double(a.pixels[i]) - double(b.pixels[i]);
    squared.add(difference * difference);
    ++count;
  }
  return count > 0 ? std::sqrt(squared.value() / double(count)) : kNotMeasured;
}

Camera turned(const Camera& camera, Point3 centre, float angle) {
  const float c = std::cos(angle), s = std::sin(angle);
  Mat4 turn(1);
  turn[0] = {c, 0, -s, 0}, turn[2] = {s, 0, c, 0};
  const Vec3 moved = centre - Vec3(turn * Vec4(centre, 0));
  turn[3] = Vec4(moved, 1);
  Camera out = camera;
  out.to_world = turn * camera.to_world;
  return out;
}

double flicker(std::span<const Image> pictures, std::span<const Image> references, float exposure) {
  Sum squared;
  size_t count = 0;
  for (size_t frame = 1; frame < pictures.size(); ++frame) {
    const Image now = exposed(pictures[frame], exposure), right_now = exposed(references[frame], exposure);
    const Image past = exposed(pictures[frame - 1], exposure), right_past = exposed(references[frame - 1], exposure);
    for (size_t i = 0; i < now.pixels.size() / 3; ++i) {
      const double change = (double(luminance_at(now, i)) - double(luminance_at(right_now, i))) -
                            (double(luminance_at(past, i)) - double(luminance_at(right_past, i)));
      squared.add(change * change);
      ++count;
    }
  }
  return count > 0 ? std::sqrt(squared.value() / double(count)) : kNotMeasured;
}

}  // namespace aktina
