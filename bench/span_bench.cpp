// Shading methods on scanlines, apart from the rest of the frame: the inner loop against linear interpolation of as
// many channels (Gouraud's), and the set-up of a span.
#include <vector>

#include "aktina/raster/shading/span.h"
#include "bench/report.h"

namespace {

using namespace aktina;

constexpr size_t kSpans = 64;

/// Spans of `width` px of a triangle whose normals turn by about 20 degrees.
struct Spans {
  TriangleGroup triangles{};
  std::vector<Span> spans;
  std::vector<Lanes> lines;
  LitArrays out;

  explicit Spans(int width) : lines(kSpans * padded(size_t(width)) / kLanes * 6) {
    triangles.count = 1, triangles.channels = 6;
    const float w = float(width);
    const Vec3 normal[3] = {{0, 0, 1}, normalize(Vec3(0.35f, 0, 1)), normalize(Vec3(0.1f, 0.3f, 1))};
    const Vec2 screen[3] = {{0, -1}, {0, 100}, {4 * w, 50}};
    for (int v = 0; v < 3; ++v)
      for (size_t i = 0; i < kLanes; ++i) {
        triangles.position[v][0][i] = screen[v].x / w, triangles.position[v][1][i] = -screen[v].y / 100;
        for (int k = 0; k < 3; ++k) triangles.normal[v][k][i] = normal[v][k];
        for (int k = 0; k < 2; ++k) triangles.screen[v][k][i] = screen[v][k];
        triangles.weight[v][i] = 1;
      }
    for (size_t i = 0; i < kSpans; ++i) {
      Span span = span_at(screen, 20.5f + float(i % 16));
      span.count = width, span.output = i * padded(size_t(width));
      spans.push_back(span);
    }
    float* const data = lines[0].v;
    const size_t size = kSpans * padded(size_t(width));
    for (size_t k = 0; k < 3; ++k) out.diffuse[k] = data + k * size, out.specular[k] = data + (3 + k) * size;
  }

  void shade(const ShadingMethod& method, const Illuminator& light) const {
    method.shade_spans(triangles, 0, spans, light, out);
  }
  void interpolate() const {
    const float left[6] = {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f}, right[6] = {0.6f, 0.5f, 0.4f, 0.3f, 0.2f, 0.1f};
    for (const Span& span : spans) fill_linear(span, left, right, out);
  }
};

/// Seconds of a pixel in the inner loop, and of a span beside it: from a short and a long one.
struct Cost {
  double pixel, span;
  Cost(double shorter, double longer, int short_width, int long_width)
      : pixel((longer - shorter) / (double(kSpans) * (long_width - short_width))),
        span(shorter / double(kSpans) - pixel * short_width) {}
};

void measure(const ShadingRow& row, const Illuminator& light, std::string_view model) {
  constexpr int kShort = 64, kLong = 448;
  const auto method = row.make(ParamSet(row.info));
  if (method->plan(light).kind != ShadingPlan::Kind::spans) return;
  const Spans few(kShort), many(kLong);
  const auto often = [](const auto& work) {
    for (int i = 0; i < 20; ++i) work();
  };
  const auto t = bench::race(
      20, {[&] { often([&] { few.shade(*method, light); }); }, [&] { often([&] { many.shade(*method, light); }); },
           [&] { often([&] { few.interpolate(); }); }, [&] { often([&] { many.interpolate(); }); }});
  const Cost ours(t[0] / 20, t[1] / 20, kShort, kLong), linear(t[2] / 20, t[3] / 20, kShort, kLong);
  if (ours.span < 0) return;  // a set-up that grows with the triangle cannot be told from its pixels
  bench::report(fmt::format("shading.{}.{}.pixel", row.info.id, model),
                fmt::format("{} shading, {}, one lamp: a pixel over one of linear interpolation ({:.2f} ns)",
                            row.info.id, model, linear.pixel * 1e9),
                ours.pixel / linear.pixel, "x", bench::Goal{2, false});
  bench::report(
      fmt::format("shading.{}.{}.span", row.info.id, model),
      fmt::format("{} shading, {}, one lamp: set-up of a span in pixels of linear interpolation", row.info.id, model),
      ours.span / linear.pixel, "px");
}

}  // namespace

int main() {
  const Surface surface{.kd = Rgb(0.6f), .ks = Rgb(0.4f), .exponent = 32};
  const Light sun = DirectionalLight{normalize(Vec3(-0.2f, -0.1f, -1)), Irradiance(Rgb(3))};
  const Viewer viewer{{0, 0, 1}, true};
  for (const ShadingRow* row : shading_methods()) {
    measure(*row, Illuminator(Lambert{}, surface, std::span(&sun, 1), Rgb(0.1f), viewer), "lambert");
    measure(*row, Illuminator(BlinnPhong{}, surface, std::span(&sun, 1), Rgb(0.1f), viewer), "blinn_phong");
  }
}
