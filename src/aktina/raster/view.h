// A camera and a picture size as the rasterizer needs them: world to pixels and back.
#pragma once

#include "aktina/illumination/illuminate.h"
#include "aktina/scene/camera.h"

namespace aktina {

/// A vertex on the screen.
struct ScreenVertex {
  int32_t x, y;  // 1/256 px, from the upper left corner of the picture
  float depth;   // linear on the screen and larger where nearer: 1 / w in perspective, else minus the distance
  float weight;  // 1 / w of the perspective division; 1 in a parallel projection
};
inline constexpr int kSubpixels = 256;
/// Polygons are cut where they leave this many pixels around the picture: beyond it, edge functions in double would
/// no longer be exact.
inline constexpr float kGuardBand = 65536;

/// Pixels of a row or a column whose centres lie in low .. high (1/256 px), within 0 .. size - 1; none if first > last.
struct PixelRange {
  int32_t first, last;
};
inline PixelRange pixel_range(int32_t low, int32_t high, int size) {
  const int32_t first = (low + kSubpixels / 2 - 1) >> 8, last = (high - kSubpixels / 2) >> 8;
  return {first < 0 ? 0 : first, last >= size ? size - 1 : last};
}

class View {
 public:
  View(const Camera& camera, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  /// World -> (x, y, distance, w): the picture is -w <= x, y <= w; distance along the view axis, m, stands for z.
  const Mat4& clip_from_world() const { return clip_from_world_; }
  float near() const { return near_; }
  float far() const { return far_; }
  const Viewer& viewer() const { return viewer_; }
  bool perspective() const { return !viewer_.distant; }

  /// @pre  inside of the clip planes
  ScreenVertex project(Vec4 clip) const;
  /// The point that pixel position (x, y) sees at a depth as in ScreenVertex.
  Point3 point(float x, float y, float depth) const {
    const Vec3 across = corner_ + x * right_ + y * down_;
    return perspective() ? eye_ + across * (1 / depth) : eye_ + across - depth * forward_;
  }
  /// What point() computes with, for many pixels at a time.
  struct Pixels {
    bool perspective;
    Vec3 eye, forward, corner, right, down;
  };
  Pixels pixels() const { return {perspective(), eye_, forward_, corner_, right_, down_}; }
  /// Distance along the view axis, m, from a depth.
  float distance(float depth) const { return perspective() ? 1 / depth : -depth; }
  /// A depth that is farther than everything that is seen.
  float farthest() const { return perspective() ? 0 : -kInfinity; }

 private:
  int width_, height_;
  Mat4 clip_from_world_;
  float near_, far_;
  Viewer viewer_;
  Point3 eye_;
  Vec3 forward_;
  // In perspective: to the points at distance 1 along the axis; else: offsets from the eye within its plane.
  Vec3 corner_, right_, down_;
};

}  // namespace aktina
