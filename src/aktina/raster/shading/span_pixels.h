// What methods that decide triangle by triangle read of a group on spans: one triangle, and where pixels are on it.
#pragma once

#include "aktina/base/function_ref.h"
#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// One triangle of a group. @pre  the plan needs position, normal, radiance and screen
struct CornerValues {
  Point3 position[3];
  Vec3 normal[3];
  Lit light[3];
  CornerValues(const TriangleGroup& triangles, int lane);
};

/// Pixels of a triangle's spans, one after the other as shade_spans writes them: barycentric coordinates of corners 1
/// and 2 on the surface. Each run of pixels is padded with copies of its last one; so is what is computed from them.
struct SpanPixels {
  static constexpr int kMost = 256;
  struct Run {
    int begin, count;
    float weight[2];  // 1 / w at its first and its last pixel
  };
  int count;      // with padding
  size_t output;  // of the first pixel in the arrays that shade_spans writes
  int run_count;
  Run runs[kMost / int(kLanes)];
  alignas(64) float b1[kMost], b2[kMost];

  /// Values that are linear on the surface, from those at the corners, for pixels begin .. end - 1 (begin a multiple of
  /// kLanes). @param out  of pixel 0
  void linear(float at0, float at1, float at2, int begin, int end, float* out) const;
};

/// Calls `visit` with the pixels of all spans, at most SpanPixels::kMost at a time.
void visit_pixels(const TriangleGroup& triangles, int lane, std::span<const Span> spans,
                  FunctionRef<void(const SpanPixels&)> visit);

/// Interpolates both parts of the corners' light: Gouraud.
void shade_linear(const CornerValues& corners, const SpanPixels& pixels, bool specular, const LitArrays& out);

/// Evaluates the highlights of all lamps at pixels begin .. end - 1, with interpolated normals: Phong.
/// @param begin, end  multiples of kLanes
void shade_highlights(const CornerValues& corners, const SpanPixels& pixels, int begin, int end,
                      const Illuminator& light, const LitArrays& out);

}  // namespace aktina
