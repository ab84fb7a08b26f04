// I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", Comm. ACM 17(1), 1974.
#include "aktina/raster/clip.h"

namespace aktina {

Clipper::Clipper(const View& view)
    : near_(view.near()),
      far_(view.far()),
      guard_x_(2 * kGuardBand / float(view.width()) - 1),
      guard_y_(2 * kGuardBand / float(view.height()) - 1) {}

/// Positive inside; linear in `clip`.
float Clipper::distance(int plane, Vec4 c) const {
  switch (plane) {
    case 0:
      return c.z - near_;
    case 1:
      return far_ < kInfinity ? far_ - c.z : 1;
    case 2:
      return guard_x_ * c.w - c.x;
    case 3:
      return guard_x_ * c.w + c.x;
    case 4:
      return guard_y_ * c.w - c.y;
    default:
      return guard_y_ * c.w + c.y;
  }
}

unsigned Clipper::outside(Vec4 clip) const {
  unsigned bits = 0;
  for (int plane = 0; plane < kPlanes; ++plane)
    if (!(distance(plane, clip) >= 0)) bits |= 1U << plane;
  return bits;
}

int Clipper::clip(const std::array<Vec4, 3>& triangle, std::array<ClipVertex, kMostClippedVertices>& out) const {
  std::array<ClipVertex, kMostClippedVertices> in;
  int count = 3;
  for (int v = 0; v < 3; ++v) out[size_t(v)] = {triangle[size_t(v)], Vec3(v == 0, v == 1, v == 2)};
  for (int plane = 0; plane < kPlanes && count > 0; ++plane) {
    in = out;
    const int before = count;
    count = 0;
    for (int i = 0; i < before; ++i) {
      const ClipVertex &a = in[size_t(i)], &b = in[size_t((i + 1) % before)];
      const float da = distance(plane, a.clip), db = distance(plane, b.clip);
      const bool a_in = da >= 0, b_in = db >= 0;
      if (a_in) out[size_t(count++)] = a;
      if (a_in == b_in) continue;
      // From the inside out, whichever way the edge runs: its other triangle then cuts it at the same place.
      const ClipVertex &from = a_in ? a : b, &to = a_in ? b : a;
      const float t = (a_in ? da : db) / ((a_in ? da : db) - (a_in ? db : da));
      out[size_t(count++)] = {from.clip + t * (to.clip - from.clip),
                              from.barycentric + t * (to.barycentric - from.barycentric)};
    }
  }
  return count < 3 ? 0 : count;
}

}  // namespace aktina
