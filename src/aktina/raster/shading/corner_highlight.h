// A lamp's highlight at the corners of a triangle, for methods that interpolate what makes it.
#pragma once

#include "aktina/raster/shading/highlight.h"
#include "aktina/raster/shading/span_pixels.h"

namespace aktina {

struct CornerHighlight {
  Vec3 normal, to_lamp, to_eye, half;  // unit; half between the two before
  float cosine;                        // of the curve
  float facing;                        // n.l; none where it is not positive
  Rgb peak;                            // radiance of the highlight where the cosine is 1, cd/m^2
};

/// @param normal  unit
CornerHighlight corner_highlight(const HighlightCurve& curve, const Illuminator& light, size_t lamp, Point3 position,
                                 Vec3 normal);

/// At the three corners of a triangle.
struct CornerHighlights {
  CornerHighlight corner[3];
  CornerHighlights(const HighlightCurve& curve, const Illuminator& light, size_t lamp, const CornerValues& corners);
  bool dark() const;  // at all corners: behind the surface, or without light
};

/// Places of the corners on a plane where the square of the distance from the origin is the highlight's fall(). The
/// normals are turned as their half vectors are turned onto a common one, in a frame about that; z is n.h.
/// C. W. A. M. van Overveld, B. Wyvill 1996, for Blinn's highlight.
struct HighlightPlaces {
  Vec3 corner[3];
  HighlightPlaces(const HighlightCurve& curve, const CornerHighlights& highlights);
};

}  // namespace aktina
