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

/// Pixels of a span: barycentric coordinates of corners 1 and 2 on the surface. The arrays are padded with the last
/// pixel's; so may be what is computed from them.
struct SpanPixels {
  static constexpr int kMost = 256;
  int count;
  size_t output;    // of the first pixel in the arrays that shade_spans writes
  float weight[2];  // 1 / w at the first and the last pixel
  alignas(64) float b1[kMost], b2[kMost];

  /// A value that is linear on the surface, from those at the corners.
  void linear(float at0, float at1, float at2, float* out) const;
};

/// Calls `visit` with the pixels of each span, in pieces of at most SpanPixels::kMost.
void visit_pixels(const TriangleGroup& triangles, int lane, std::span<const Span> spans,
                  FunctionRef<void(const SpanPixels&)> visit);

/// Interpolates both parts of the corners' light: Gouraud.
void shade_linear(const CornerValues& corners, const SpanPixels& pixels, bool specular, const LitArrays& out);

/// Evaluates the highlights of all lamps at pixels first .. first + count - 1, with interpolated normals: Phong.
/// @param first  a multiple of kLanes
void shade_highlights(const CornerValues& corners, const SpanPixels& pixels, int first, int count,
                      const Illuminator& light, const LitArrays& out);

}  // namespace aktina
