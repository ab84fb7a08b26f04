#include "aktina/raster/shading/shade_triangle.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "aktina/base/error.h"
#include "aktina/raster/shading/span.h"

namespace aktina {
namespace {

Vec3 on_surface(const ShadedTriangle& t, Vec3 b) {
  const Vec3 weighted = b * Vec3(t.weight[0], t.weight[1], t.weight[2]);
  return weighted / (weighted.x + weighted.y + weighted.z);
}

template <class V>
V mix(const V (&corners)[3], Vec3 b) {
  return b.x * corners[0] + b.y * corners[1] + b.z * corners[2];
}

TriangleGroup group_of(const ShadedTriangle& t, const Illuminator& light) {
  TriangleGroup g{};
  g.count = 1, g.channels = 6;
  const Vec3 face = normalize_or(cross(t.position[1] - t.position[0], t.position[2] - t.position[0]), t.normal[0]);
  for (int v = 0; v < 3; ++v) {
    const Lit lit =
        illuminate(light.model(), light.surface(), light.lights(), light.ambient(), t.position[v], t.normal[v],
                   light.viewer().towards(t.position[v]), light.viewer().cue.at(t.position[v]));
    for (size_t i = 0; i < kLanes; ++i) {
      for (int k = 0; k < 3; ++k) {
        g.position[v][k][i] = t.position[v][k], g.normal[v][k][i] = t.normal[v][k], g.face_normal[k][i] = face[k];
        g.radiance[v][k][i] = lit.diffuse[k], g.radiance[v][3 + k][i] = lit.specular[k];
      }
      for (int k = 0; k < 2; ++k) g.screen[v][k][i] = t.screen[v][k];
      g.weight[v][i] = t.weight[v];
    }
  }
  return g;
}

/// Lit points, in aligned arrays.
class Points {
 public:
  explicit Points(size_t count) : lanes_(padded(count) / kLanes * 6) {
    for (size_t k = 0; k < 6; ++k) channel_[k] = lanes_.data()[k * padded(count) / kLanes].v;
  }
  LitArrays arrays(size_t first = 0) const {
    return {{channel_[0] + first, channel_[1] + first, channel_[2] + first},
            {channel_[3] + first, channel_[4] + first, channel_[5] + first}};
  }
  Lit at(size_t i) const {
    return {{channel_[0][i], channel_[1][i], channel_[2][i]}, {channel_[3][i], channel_[4][i], channel_[5][i]}};
  }

 private:
  std::vector<Lanes> lanes_;
  float* channel_[6];
};

std::vector<Lit> shade_polynomial(const ShadingMethod& method, const ShadingPlan& plan, const Illuminator& light,
                                  const ShadedTriangle& triangle, std::span<const Vec3> barycentric) {
  const bool colour = plan.kind == ShadingPlan::Kind::colour;
  const int channels = colour ? 6 : plan.channels, points = int(lattice(plan.degree).size());
  std::vector<Lanes> values(size_t(points * channels));
  const Samples samples(values.data(), channels);
  method.prepare(group_of(triangle, light), light, samples);

  const size_t stride = padded(barycentric.size());
  std::vector<Lanes> storage(stride / kLanes * size_t(channels + 3));  // channels, then positions
  float* const data = storage.empty() ? nullptr : storage[0].v;
  std::vector<Lit> result(barycentric.size());
  for (size_t i = 0; i < barycentric.size(); ++i) {
    const Vec3 surface = on_surface(triangle, barycentric[i]);
    float weights[kMostLatticePoints];
    lagrange(plan.degree, plan.perspective ? surface : barycentric[i], std::span(weights, size_t(points)));
    const Point3 p = mix(triangle.position, surface);
    for (int k = 0; k < 3; ++k) data[size_t(channels + k) * stride + i] = p[k];
    for (int c = 0; c < channels; ++c)
      for (int point = 0; point < points; ++point)
        data[size_t(c) * stride + i] += weights[point] * samples(point, c)[0];
    const auto channel = [&](int c) { return data[size_t(c) * stride + i]; };
    if (colour) result[i] = {{channel(0), channel(1), channel(2)}, {channel(3), channel(4), channel(5)}};
  }
  if (colour) return result;

  std::vector<const float*> channel(size_t(channels) + 3);
  for (size_t c = 0; c < channel.size(); ++c) channel[c] = data + c * stride;
  const float* const* position = channel.data() + channels;
  const Points out(barycentric.size());
  method.shade({barycentric.size(), channel.data(), {position[0], position[1], position[2]}, nullptr}, light,
               out.arrays());
  for (size_t i = 0; i < result.size(); ++i) result[i] = out.at(i);
  return result;
}

/// The method asks for pixels at whole numbers and a half: the screen is moved until the point is one.
Lit shade_on_span(const ShadingMethod& method, const Illuminator& light, ShadedTriangle triangle, Vec3 barycentric) {
  const Vec2 shift = Vec2(0.5f, 0.5f) - mix(triangle.screen, barycentric);
  for (Vec2& corner : triangle.screen) corner += shift;
  const auto [top, bottom] = std::minmax({triangle.screen[0].y, triangle.screen[1].y, triangle.screen[2].y});
  Span span = span_at(triangle.screen, std::clamp(0.5f, top, bottom));
  span.count = 1;
  if (!(span.right.x > -kInfinity))
    throw Error(Code::bad_param, "shading.screen", "the triangle has no area on the screen");
  const Points out(1);
  method.shade_spans(group_of(triangle, light), 0, std::span(&span, 1), light, out.arrays());
  return out.at(0);
}

}  // namespace

void lagrange(int degree, Vec3 barycentric, std::span<float> weights) {
  const auto points = lattice(degree);
  for (size_t i = 0; i < points.size(); ++i) {
    weights[i] = 1;
    for (int axis = 0; axis < 3 && degree > 0; ++axis) {
      const int order = int(std::lround(points[i][size_t(axis)] * float(degree)));
      for (int m = 0; m < order; ++m) weights[i] *= (float(degree) * barycentric[axis] - float(m)) / float(m + 1);
    }
  }
}

std::vector<Lit> shade(const ShadingMethod& method, const Illuminator& light, const ShadedTriangle& triangle,
                       std::span<const Vec3> barycentric) {
  const ShadingPlan plan = method.plan(light);
  if (plan.kind != ShadingPlan::Kind::spans) return shade_polynomial(method, plan, light, triangle, barycentric);
  std::vector<Lit> result;
  for (const Vec3 b : barycentric) result.push_back(shade_on_span(method, light, triangle, b));
  return result;
}

}  // namespace aktina
