// The pixels of a scanline whose normals lie within a cone.
#pragma once

#include "aktina/raster/shading/highlight.h"

namespace aktina {

/// Pixels begin .. end - 1 of a span; none where begin == end.
struct HighlightTrack {
  int begin, end;
};

/// Where (n.h)^2 >= K^2 n.n and n.h >= 0, for the axis h and the cosine K of a cone: a conic on the screen, of which
/// the scanline cuts out one stretch, since a cone narrower than a half space is convex. The whole span for wider ones.
/// @param first, last  normals at the first and the last pixel, of any length, linear on the screen between them
HighlightTrack highlight_track(const HighlightCone& cone, Vec3 first, Vec3 last, int count);

}  // namespace aktina
