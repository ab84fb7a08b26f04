// Where on a triangle a highlight can be: the tests that methods make before they spend work on it.
//
// A highlight is a power of the cosine between the normal and the half vector (Blinn), or between mirror and view
// (Phong). Over a triangle, normalised linear normals fill a spherical triangle, and the directions to a lamp and to
// the viewer spherical triangles of their own. All three are bounded here; what is said to be dark is dark.
#pragma once

#include <span>
#include <string_view>

#include "aktina/raster/shading/shading_method.h"

namespace aktina {

/// The highlight of an illumination model, as a function of one cosine.
struct HighlightCurve {
  enum class Power { none, exact, schlick, facets };  // none: the model has no highlights; facets: no power

  Power power = Power::none;
  bool half = false;    // of the angle between normal and half vector; else between mirror and view direction
  bool varies = false;  // times a factor of at most 1 that is no function of the cosine (Fresnel's, shadows of facets)
  float exponent = 1;   // not below 0
  FacetDistribution distribution = FacetDistribution::phong;  // of facets, and its width
  float width = 1;

  /// How far from the peak: 0 there, 1 where the cosine is 0, rising on beyond. The square of a sine where the cosine
  /// is Blinn's; 1 less the cosine where it is Phong's, whose angle is twice as large: both go with the square of the
  /// angle between normal and half vector.
  float fall(float cosine) const { return half ? 1 - cosine * (cosine > 0 ? cosine : -cosine) : 1 - cosine; }

  /// The least cosine, in [0, 1], where the highlight is `share` of its peak; 2 for shares above 1. Of facets the peak
  /// is 2 D(0) F / v.h, the most that the model can give at the lamp's and viewer's directions.
  float cosine_at(float share) const;
};

/// @param method  whose error it is
/// @throws Error unsupported: a model whose highlight is no power of a cosine
HighlightCurve highlight_curve(const Illuminator& light, std::string_view method);
/// The same for methods that know nothing but the cosine. @throws Error unsupported: also where `varies`
HighlightCurve sole_highlight_curve(const Illuminator& light, std::string_view method);

/// The largest n.h between two unit normals that are interpolated linearly and normalised.
struct EdgePeak {
  float cosine, t;  // n at (1 - t) n0 + t n1
};
EdgePeak edge_peak(Vec3 n0, Vec3 n1, Vec3 h);

/// The largest n.h over a triangle: exact for a constant unit h. Harrison, Mitchell, Watt 1988.
float highlight_peak(const Vec3 (&normal)[3], Vec3 h);

/// Normals that can show a lamp's highlight: those within acos(cosine) of the axis. All where cosine <= -1, none where
/// it is 2.
struct HighlightCone {
  Vec3 axis;
  float cosine;
};

/// Holds for all points between the given ones (an edge, a triangle), wherever lamp and viewer are.
/// @param least  cosine_at() the share of the peak that counts
HighlightCone highlight_cone(const HighlightCurve& curve, float least, const Lamp& lamp, const Viewer& viewer,
                             std::span<const Point3> corners);

/// Whether a triangle can show a lamp's highlight. False is certain, up to the rounding that is allowed for.
bool may_shine(const HighlightCurve& curve, float least, const Lamp& lamp, const Viewer& viewer,
               const Point3 (&position)[3], const Vec3 (&normal)[3]);

/// may_shine() with any lamp, for a group: bit i for triangle i. @pre  position and normal are filled
uint32_t may_shine(const HighlightCurve& curve, float least, const Illuminator& light, const TriangleGroup& triangles);

/// The highlight over its peak from fall(): many at once, in place. Dark from 1 on.
/// @param values  aligned, padded to a multiple of kLanes
void highlight_values(const HighlightCurve& curve, float* values, size_t count);

}  // namespace aktina
