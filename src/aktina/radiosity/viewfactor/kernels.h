// The inner loops of the exchange areas, for all instruction sets: Lambert's closed form for many polygons or points at
// once, and what convex polygons hide of it, exactly, by cutting contours with pyramids of sight.
//
// float where a relative error of about 1e-6 of the unobstructed factor is good enough, else double.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aktina/radiosity/viewfactor/leaves.h"

namespace aktina {

inline constexpr size_t kMostSource = 5;     // corners of a source: four, and one more where a plane has cut it
inline constexpr size_t kMostBlocking = 16;  // corners of a blocking polygon, cut by two planes

/// acos(1 - u) / sqrt(u (2 - u)), the angle over its sine, for 0 <= u <= 1: powers of the polynomial that interpolates
/// it at the Chebyshev points. Errors 1.3e-7 and 1.2e-14.
template <class T>
struct AngleOverSine;
template <>
struct AngleOverSine<float> {
  static constexpr float kPowers[] = {1.0000000630F,  0.3333231652F, 0.1336003938F,  0.0544793815F, 0.0384734790F,
                                      -0.0236417311F, 0.0587827332F, -0.0414066488F, 0.0171853692F};
};
template <>
struct AngleOverSine<double> {
  static constexpr double kPowers[] = {0.9999999999999942,    0.33333333333707943,    0.13333333293153288,
                                       0.057142874167661596,  0.025396446254891757,   0.011549129921394632,
                                       0.005282455244071319,  0.0027682688051003912,  -8.596667428228739e-05,
                                       0.004676957073812865,  -0.009835323562752032,  0.01868105538342525,
                                       -0.025420215262208206, 0.02583797410455276,    -0.018743827089983144,
                                       0.00929633749457779,   -0.0028221040087481326, 0.00040559867476415066};
};

/// Sixteen polygons of one plane; corners beyond a polygon's own repeat its last one.
template <class T>
struct SourceLanes {
  alignas(64) T corners[kMostSource][3][kLeaf];
  int count;  // corners in use
};

/// A receiving point, and the area that it stands for.
template <class T>
struct ReceiverPoint {
  T x[3], weight;
};

/// sums[j] += sum over points of weight F(point -> polygon j).  n: unit normal at the points.
void add_lanes(const SourceLanes<float>& sources, const ReceiverPoint<float>* points, size_t count, const float n[3],
               float sums[kLeaf]);
void add_lanes(const SourceLanes<double>& sources, const ReceiverPoint<double>* points, size_t count, const double n[3],
               double sums[kLeaf]);

/// Convex polygons in front of receiver and source, and outlines of convex bodies, which need not be planar; all
/// coordinates are relative to one origin.
template <class T>
struct BlockingPolygon {
  T corners[kMostBlocking][3];
  int count;            // 0: nothing of it is in between, it only tells where its blocker is
  T normal[3], offset;  // plane: dot(normal, x) = offset; of an outline: (0, 0, 0), -1, so that all see its front
  bool two_sided;       // hides when seen from behind, too
  bool first;           // of its blocker: their shadows do not overlap
  bool closed;          // points behind all of its polygons see nothing
};

/// Receiving points in lanes, and the areas that they stand for.
template <class T>
struct PointLanes {
  alignas(64) T x[3][kLeaf];
  alignas(64) T areas[kLeaf];
};

/// Exchange areas: unobstructed; what is certainly seen; what may be seen.
struct Shares {
  double whole = 0, low = 0, high = 0;
  double seen() const { return 0.5 * (low + high); }
  void operator+=(const Shares& other) { whole += other.whole, low += other.low, high += other.high; }
};

/// Of each point: to the whole source; without all that blockers hide, shadows that overlap counted twice; without what
/// the blocker hides that hides most. And their sums.
template <class T>
struct Seen {
  alignas(64) T whole[kLeaf], low[kLeaf], high[kLeaf];
  Shares all;
};

template <class T>
struct SourcePolygon {
  T corners[kMostSource][3];
  int count;
};

void look(const PointLanes<float>& points, const float n[3], const SourcePolygon<float>& source,
          const BlockingPolygon<float>* blocking, size_t count, Seen<float>& seen);
void look(const PointLanes<double>& points, const double n[3], const SourcePolygon<double>& source,
          const BlockingPolygon<double>* blocking, size_t count, Seen<double>& seen);

/// Whether anything is hidden from any of the points, much faster than look(). May say true where nothing is.
bool may_hide(const PointLanes<float>& points, const SourcePolygon<float>& source,
              const BlockingPolygon<float>* blocking, size_t count);
bool may_hide(const PointLanes<double>& points, const SourcePolygon<double>& source,
              const BlockingPolygon<double>* blocking, size_t count);

/// Of the sources in `lanes`, those that a convex blocker hides wholly from a receiver: a segment between two corners
/// is stopped where the blocker's bounds leave some of it behind all of them.
/// @param receiver, sources  heights of corners over the bounds: [bound][4 corners][16 polygons], of the receiver from
///                           its own lane on
/// @param surface            bounds in whose plane the blocker itself lies: segments that end there are not stopped
uint32_t blocked_lanes(const float* receiver, const float* sources, size_t bounds, size_t surface, float tolerance,
                       uint32_t lanes);

}  // namespace aktina
