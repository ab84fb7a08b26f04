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
  const unsigned beyond[3] = {outside(triangle[0]), outside(triangle[1]), outside(triangle[2])};
  if (beyond[0] & beyond[1] & beyond[2]) return 0;
  std::array<ClipVertex, kMostClippedVertices> in;
  std::array<float, kMostClippedVertices> distances;
  int count = 3;
  for (int v = 0; v < 3; ++v) out[size_t(v)] = {triangle[size_t(v)], Vec3(v == 0, v == 1, v == 2)};
  for (int plane = 0; plane < kPlanes && count > 0; ++plane) {
    if (!((beyond[0] | beyond[1] | beyond[2]) >> plane & 1)) continue;
    const int before = count;
    for (int i = 0; i < before; ++i)
      in[size_t(i)] = out[size_t(i)], distances[size_t(i)] = distance(plane, in[size_t(i)].clip);
    count = 0;
    for (int i = 0; i < before; ++i) {
      const int next = i + 1 == before ? 0 : i + 1;
      const ClipVertex &a = in[size_t(i)], &b = in[size_t(next)];
      const float da = distances[size_t(i)], db = distances[size_t(next)];
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
