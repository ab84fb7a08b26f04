// Attributes of a triangle as numbers in a row: polynomials that a pixel evaluates.
//
//   perspective-correct barycentric coordinates of the draw list's triangle, two planes, where textures ask for them
//   barycentric coordinates of the corners, two planes, where the degree is 2 or 3
//   a polynomial for each channel: a plane over the pixels (degree 1), or in the coordinates before (degree 2 and 3)
//
// A plane is {constant, d/dx, d/dy} from the origin of the triangle's record. What is linear on the surface is divided
// by w before, and by the plane of 1 / w at the pixel.
#pragma once

#include <cstddef>

#include "aktina/raster/corner_group.h"
#include "aktina/raster/triangle_record.h"

namespace aktina {

inline constexpr int kMostChannels = 8;

struct PlaneLayout {
  int channels = 0, degree = 0;
  bool perspective = false;  // as ShadingPlan
  bool surface = false;      // with the coordinates that textures ask for

  int terms() const { return (degree + 1) * (degree + 2) / 2; }
  int screen_at() const { return surface ? 6 : 0; }
  int channel_at(int channel) const { return screen_at() + (degree >= 2 ? 6 : 0) + channel * terms(); }
  int size() const { return channel_at(channels); }
  size_t lines() const { return padded(size_t(size())) / kLanes; }
};
inline constexpr int kMostPlaneValues = 6 + 6 + kMostChannels * 10;

/// Coefficients of 1, u, v, u^2, uv, v^2, u^3, u^2 v, u v^2, v^3 from values at the points of a lattice of degree 2
/// or 3, where u and v are the barycentric coordinates of corners 1 and 2: a matrix, row after row.
const float* lattice_to_polynomial(int degree);

/// Writes the polynomials of a group, kLanes times `stride` floats (a multiple of kLanes).
/// @param samples  as ShadingMethod::prepare() filled them: lattice point by lattice point, `layout.channels` each
void write_planes(const PlaneLayout& layout, const CornerGroup& group, const ScreenPlanes& planes,
                  bool perspective_view, const Lanes* samples, float* out, size_t stride);

}  // namespace aktina
