#include "aktina/raster/shading/highlight_form.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/random.h"
#include "aktina/raster/shading/span.h"

namespace aktina {
namespace {

/// A triangle on the screen, and light on the pixels of its scanlines.
struct HighlightFormTest : testing::Test {
  static constexpr size_t kPixels = 2048;
  struct alignas(64) Arrays {
    float diffuse[3][kPixels], specular[3][kPixels];
  };
  TriangleGroup group{};
  std::vector<Span> spans;
  std::unique_ptr<Arrays> arrays = std::make_unique<Arrays>();
  CornerHighlights lit{HighlightCurve(), Illuminator(Lambert{}, {}, std::span(&kLamp, 1), Rgb(), {}), 0, {group, 0}};
  inline static const Light kLamp = PointLight{{0, 0, 1}, Intensity(Rgb(1)), {}};

  HighlightFormTest() {
    for (CornerHighlight& corner : lit.corner) corner.facing = 1, corner.peak = Rgb(1);
    place({{3.2f, 90.1f}, {98.7f, 70.3f}, {40.2f, 2.6f}}, {1, 1, 1});
  }
  void place(const Vec2 (&screen)[3], const float (&weight)[3]) {
    for (int v = 0; v < 3; ++v) {
      for (int k = 0; k < 2; ++k) group.screen[v][k][0] = screen[v][k];
      group.weight[v][0] = weight[v];
    }
    spans.clear();
    size_t output = 0;
    for (int y = 5; y < 88; y += 9) {
      Span span = span_at(screen, float(y) + 0.5f);
      span.first = int(std::ceil(span.left.x - 0.5f)),
      span.count = int(std::floor(span.right.x - 0.5f)) - span.first + 1;
      span.output = output, output += padded(size_t(span.count));
      spans.push_back(span);
    }
  }
  LitArrays out() const {
    Arrays& a = *arrays;
    return {{a.diffuse[0], a.diffuse[1], a.diffuse[2]}, {a.specular[0], a.specular[1], a.specular[2]}};
  }
  template <class Form>
  void expect_recurrence(const Form& form, const HighlightCurve& curve) {
    *arrays = {};
    visit_pixels(group, 0, spans, [&](const SpanPixels& pixels) {
      add_highlight(curve, lit, form, pixels, out());
      for (const SpanPixels::Run& run : std::span(pixels.runs, size_t(pixels.run_count))) {
        const int i = run.begin, next = run.begin + (run.count > 1);
        std::vector<float> fall = fall_recurrence(form, pixels.b1[i], pixels.b2[i], pixels.b1[next] - pixels.b1[i],
                                                  pixels.b2[next] - pixels.b2[i], run.count);
        for (int k = 0; k < run.count; ++k) {
          const float cosine = std::max(1 - std::max(fall[size_t(k)], 0.0f), 0.0f);
          EXPECT_NEAR(arrays->specular[1][pixels.output + size_t(i + k)], std::pow(cosine, curve.exponent / 2), 3e-3f);
        }
      }
    });
  }
};

const HighlightCurve kBlinn{.power = HighlightCurve::Power::exact, .half = true, .exponent = 20};

TEST_F(HighlightFormTest, PlacesInClosedFormAreThePublishedRecurrence) {
  expect_recurrence(PlaceForm{{{-0.4f, 0.1f, 0.9f}, {0.5f, 0.3f, 0.8f}, {0.1f, -0.6f, 0.8f}}}, kBlinn);
}

TEST_F(HighlightFormTest, QuadraticsInClosedFormAreThePublishedRecurrence) {
  expect_recurrence(QuadraticForm{{0.3f, -0.4f, 0.2f, 0.5f, -0.3f, 0.1f}}, kBlinn);
}

TEST_F(HighlightFormTest, PixelsLieOnTheSurface) {
  // Perspective: what is linear on the surface, times 1 / w, is linear on the screen.
  place({{3.2f, 90.1f}, {98.7f, 70.3f}, {40.2f, 2.6f}}, {1, 0.25f, 0.6f});
  size_t seen = 0;
  visit_pixels(group, 0, spans, [&](const SpanPixels& pixels) {
    for (const SpanPixels::Run& run : std::span(pixels.runs, size_t(pixels.run_count)))
      for (int i = 0; i < run.count; ++i) {
        const Span& span = spans[seen];
        const float b1 = pixels.b1[run.begin + i], b2 = pixels.b2[run.begin + i], b0 = 1 - b1 - b2;
        Vec2 place(0);
        float sum = 0;
        const float b[] = {b0, b1, b2};
        for (int v = 0; v < 3; ++v) {
          const float w = b[v] / group.weight[v][0];
          place += w * Vec2(group.screen[v][0][0], group.screen[v][1][0]), sum += w;
        }
        EXPECT_NEAR(place.x / sum, float(span.first + i) + 0.5f, 2e-3f);
        EXPECT_NEAR(place.y / sum, span.y, 2e-3f);
        if (i == run.count - 1) ++seen;
      }
  });
  EXPECT_EQ(seen, spans.size());
}

TEST_F(HighlightFormTest, LampsBehindTheSurfaceAddNothing) {
  lit.corner[0].facing = 1, lit.corner[1].facing = -1, lit.corner[2].facing = -1;
  *arrays = {};
  visit_pixels(group, 0, spans, [&](const SpanPixels& pixels) {
    add_highlight(kBlinn, lit, QuadraticForm{}, pixels, out());
    for (int i = 0; i < pixels.count; ++i)
      EXPECT_NEAR(arrays->specular[0][pixels.output + size_t(i)], pixels.b1[i] + pixels.b2[i] < 0.5f ? 1 : 0, 1e-4f);
  });
}

}  // namespace
}  // namespace aktina
