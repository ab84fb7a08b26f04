#include "aktina/radiosity/viewfactor/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/radiosity/viewfactor/kernels_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace aktina {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// See AngleOverSine.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V angle_over_sine(D d, V u) {
  using T = hn::TFromD<D>;
  constexpr auto& c = AngleOverSine<T>::kPowers;
  constexpr int n = int(sizeof c / sizeof c[0]);
  V sum = hn::Set(d, c[n - 1]);
  for (int k = n - 2; k >= 0; --k) sum = hn::MulAdd(sum, u, hn::Set(d, c[k]));
  return sum;
}

template <class V>
struct Three {
  V x, y, z;
};
template <class V>
HWY_INLINE V dot(const Three<V>& a, const Three<V>& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, a.z * b.z));
}
template <class V>
HWY_INLINE Three<V> cross(const Three<V>& a, const Three<V>& b) {
  return {hn::MulSub(a.y, b.z, a.z * b.y), hn::MulSub(a.z, b.x, a.x * b.z), hn::MulSub(a.x, b.y, a.y * b.x)};
}
template <class V>
HWY_INLINE Three<V> operator-(const Three<V>& a, const Three<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
HWY_INLINE Three<V> along(const Three<V>& a, const Three<V>& b, V t) {
  return {hn::MulAdd(t, b.x - a.x, a.x), hn::MulAdd(t, b.y - a.y, a.y), hn::MulAdd(t, b.z - a.z, a.z)};
}
template <class D, class T = hn::TFromD<D>>
HWY_INLINE Three<hn::Vec<D>> spread(D d, const T (&a)[3]) {
  return {hn::Set(d, a[0]), hn::Set(d, a[1]), hn::Set(d, a[2])};
}

template <class D>
HWY_INLINE hn::Vec<D> inverse_root(D d, hn::Vec<D> x) {
  using T = hn::TFromD<D>;
  x = hn::Max(x, hn::Set(d, T(1e-30)));
  if constexpr (sizeof(T) == 4) {
    const auto y = hn::ApproximateReciprocalSqrt(x);
    return y * hn::NegMulAdd(x * hn::Set(d, 0.5F) * y, y, hn::Set(d, 1.5F));
  } else {
    return hn::Set(d, T(1)) / hn::Sqrt(x);
  }
}

/// a / b to a few units in the last place; anything where b is 0.
template <class D>
HWY_INLINE hn::Vec<D> quotient(D d, hn::Vec<D> a, hn::Vec<D> b) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    const auto r = hn::ApproximateReciprocal(b);
    return a * (r * hn::NegMulAdd(b, r, hn::Set(d, 2.0F)));
  } else {
    return a / b;
  }
}

/// n . side over |side|, times the angle between two corners: what an edge adds to the contour integral.
/// @param product, ra, rb  a . b and one over the distances;  @param facing  n . side
template <class D, class V = hn::Vec<D>>
HWY_INLINE V edge_term(D d, V product, V ra, V rb, const Three<V>& side, V facing) {
  using T = hn::TFromD<D>;
  const auto r = ra * rb, cosine = product * r;
  const auto u = hn::Max(hn::Set(d, T(1)) - hn::Abs(cosine), hn::Zero(d));
  const auto g = angle_over_sine(d, u);
  auto term = facing * g * r;
  const auto obtuse = cosine < hn::Zero(d);
  if (HWY_UNLIKELY(!hn::AllFalse(d, obtuse))) {
    // Near the line of the edge its sine has no digits left, but n . side / |side| stays bounded.
    const auto angle = hn::NegMulAdd(g, hn::Sqrt(u * (hn::Set(d, T(2)) - u)), hn::Set(d, T(3.14159265358979323846)));
    term = hn::IfThenElse(obtuse, angle * facing * inverse_root(d, dot(side, side)), term);
  }
  return term;
}

constexpr double kTwoPi = 6.28318530717958647693;

template <class T>
HWY_INLINE void LanesOf(const SourceLanes<T>& sources, const ReceiverPoint<T>* points, size_t count, const T* normal,
                        T* sums) {
  const hn::CappedTag<T, kLeaf> d;
  using V = hn::Vec<std::remove_const_t<decltype(d)>>;
  const T n[3] = {normal[0], normal[1], normal[2]};
  const auto normals = spread(d, n);
  for (size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    auto sum = hn::Zero(d);
    for (size_t p = 0; p < count; ++p) {
      const auto x = spread(d, points[p].x);
      const auto corner = [&](int k) {
        return Three<V>{hn::Load(d, sources.corners[k][0] + lane) - x.x,
                        hn::Load(d, sources.corners[k][1] + lane) - x.y,
                        hn::Load(d, sources.corners[k][2] + lane) - x.z};
      };
      auto factor = hn::Zero(d);
      const auto first = corner(0);
      const auto first_r = inverse_root(d, dot(first, first));
      auto a = first;
      auto ra = first_r;
      for (int k = 1; k <= sources.count; ++k) {
        const bool last = k == sources.count;
        const auto b = last ? first : corner(k);
        const auto rb = last ? first_r : inverse_root(d, dot(b, b));
        const auto side = cross(b, a);
        factor = factor + edge_term(d, dot(a, b), ra, rb, side, dot(normals, side));
        a = b, ra = rb;
      }
      sum = hn::MulAdd(hn::Set(d, points[p].weight), factor, sum);
    }
    hn::Store(hn::MulAdd(sum, hn::Set(d, T(1 / kTwoPi)), hn::Load(d, sums + lane)), d, sums + lane);
  }
}

/// Keeps of the edge between heights a and b the part where they are positive: [from, to].
template <class D>
HWY_INLINE void cut(D d, hn::Vec<D> a, hn::Vec<D> b, hn::Vec<D>& from, hn::Vec<D>& to) {
  using T = hn::TFromD<D>;
  const auto zero = hn::Zero(d);
  const auto t = quotient(d, a, a - b);
  const auto a_out = a <= zero, b_out = b <= zero;
  from = hn::IfThenElse(hn::AndNot(b_out, a_out), hn::Max(from, t), from);
  to = hn::IfThenElse(hn::AndNot(a_out, b_out), hn::Min(to, t), to);
  to = hn::IfThenElse(hn::And(a_out, b_out), hn::Set(d, T(-1)), to);
}

/// The source as the points in the lanes see it.
template <class D>
struct View {
  using V = hn::Vec<D>;
  Three<hn::Vec<D>> corners[kMostSource], sides[kMostSource];  // sides: inward normals of the pyramid of sight
  V facing[kMostSource];                                       // n . side
  V terms[kMostSource];                                        // of whole edges, in the contour integral
  int count;
};

/// Contour integral over the kept part of an edge.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V part(D d, const Three<V>& a, const Three<V>& b, V from, V to, const Three<V>& side, V facing) {
  const auto kept = to > from;
  if (hn::AllFalse(d, kept)) return hn::Zero(d);
  const auto p = along(a, b, from), q = along(a, b, to);
  const auto share = to - from;  // the part's side is as much smaller
  const Three<V> own{side.x * share, side.y * share, side.z * share};
  return hn::IfThenElseZero(
      kept, edge_term(d, dot(p, q), inverse_root(d, dot(p, p)), inverse_root(d, dot(q, q)), own, facing * share));
}

/// A blocking polygon as the points see it.
template <class D>
struct Pyramid {
  using V = hn::Vec<D>;
  Three<V> corners[kMostBlocking], sides[kMostBlocking];
  V heights[kMostBlocking][kMostSource];  // of the source's corners over the sides
  int count;
  int cutting[kMostBlocking], cuts;  // sides that do not have all of the source inside
};

/// False where the source is beside the polygon for all points.
/// @param seen  +1 where its front is seen, -1 its back
template <class D, class T = hn::TFromD<D>>
HWY_INLINE bool look_past(D d, const View<D>& source, const Three<hn::Vec<D>>& x, const BlockingPolygon<T>& polygon,
                          hn::Vec<D> seen, Pyramid<D>& pyramid) {
  const auto zero = hn::Zero(d);
  pyramid.count = polygon.count, pyramid.cuts = 0;
  for (int k = 0; k < polygon.count; ++k) pyramid.corners[k] = spread(d, polygon.corners[k]) - x;
  for (int k = 0; k < polygon.count; ++k) {
    auto& side = pyramid.sides[k];
    side = cross(pyramid.corners[k + 1 == polygon.count ? 0 : k + 1], pyramid.corners[k]);
    side = {side.x * seen, side.y * seen, side.z * seen};
    auto highest = pyramid.heights[k][0] = dot(side, source.corners[0]);
    auto lowest = highest;
    for (int e = 1; e < source.count; ++e) {
      const auto height = pyramid.heights[k][e] = dot(side, source.corners[e]);
      highest = hn::Max(highest, height), lowest = hn::Min(lowest, height);
    }
    if (hn::AllFalse(d, highest > zero)) return false;
    if (!hn::AllTrue(d, lowest > zero)) pyramid.cutting[pyramid.cuts++] = k;
  }
  return true;
}

/// 2 pi times the form factor of the part of the source that the polygon covers. Sides that have all of the source
/// inside do not meet it.
template <class D, class T = hn::TFromD<D>>
HWY_INLINE hn::Vec<D> covered(D d, const View<D>& source, const Three<hn::Vec<D>>& n, const Pyramid<D>& polygon) {
  const auto zero = hn::Zero(d), one = hn::Set(d, T(1));
  auto sum = zero;
  for (int i = 0; i < polygon.cuts; ++i) {
    const int k = polygon.cutting[i], next = k + 1 == polygon.count ? 0 : k + 1;
    const auto &a = polygon.corners[k], &b = polygon.corners[next];
    auto begin = zero, end = one;
    for (int e = 0; e < source.count; ++e) cut(d, dot(source.sides[e], a), dot(source.sides[e], b), begin, end);
    sum = sum + part(d, a, b, begin, end, polygon.sides[k], dot(n, polygon.sides[k]));
  }
  for (int e = 0; e < source.count; ++e) {
    const int next = e + 1 == source.count ? 0 : e + 1;
    auto begin = zero, end = one;
    for (int i = 0; i < polygon.cuts; ++i) {
      const auto& heights = polygon.heights[polygon.cutting[i]];
      cut(d, heights[e], heights[next], begin, end);
    }
    const bool whole = hn::AllTrue(d, hn::And(begin == zero, end == one));
    sum =
        sum + (whole ? source.terms[e]
                     : part(d, source.corners[e], source.corners[next], begin, end, source.sides[e], source.facing[e]));
  }
  return sum;
}

/// Where the points are over a blocking polygon's plane.
template <class D, class T = hn::TFromD<D>>
HWY_INLINE hn::Vec<D> height_over(D d, const BlockingPolygon<T>& polygon, const Three<hn::Vec<D>>& x) {
  return dot(spread(d, polygon.normal), x) - hn::Set(d, polygon.offset);
}

template <class D, class T = hn::TFromD<D>>
HWY_INLINE Three<hn::Vec<D>> points_at(D d, const PointLanes<T>& points, size_t lane) {
  return {hn::Load(d, points.x[0] + lane), hn::Load(d, points.x[1] + lane), hn::Load(d, points.x[2] + lane)};
}

template <class D, class T = hn::TFromD<D>>
HWY_INLINE void place(D d, const SourcePolygon<T>& polygon, const Three<hn::Vec<D>>& x, View<D>& source) {
  source.count = polygon.count;
  for (int k = 0; k < polygon.count; ++k) source.corners[k] = spread(d, polygon.corners[k]) - x;
}

template <class T>
constexpr T kEdgeOn = sizeof(T) == 4 ? T(1e-6) : T(1e-12);

template <class T>
HWY_INLINE void LookAt(const PointLanes<T>& points, const T* normal, const SourcePolygon<T>& polygon,
                       const BlockingPolygon<T>* blocking, size_t count, Seen<T>& seen) {
  const hn::CappedTag<T, kLeaf> d;
  using D = std::remove_const_t<decltype(d)>;
  const T n3[3] = {normal[0], normal[1], normal[2]};
  const auto n = spread(d, n3);
  const auto zero = hn::Zero(d), one = hn::Set(d, T(1)), edge_on = hn::Set(d, kEdgeOn<T>);
  auto whole_sum = zero, low_sum = zero, high_sum = zero;
  for (size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    const auto x = points_at(d, points, lane);
    View<D> source;
    place(d, polygon, x, source);
    auto whole = zero;
    for (int k = 0; k < polygon.count; ++k) {
      const auto &a = source.corners[k], &b = source.corners[k + 1 == polygon.count ? 0 : k + 1];
      source.sides[k] = cross(b, a);
      source.facing[k] = dot(n, source.sides[k]);
      source.terms[k] = edge_term(d, dot(a, b), inverse_root(d, dot(a, a)), inverse_root(d, dot(b, b)), source.sides[k],
                                  source.facing[k]);
      whole = whole + source.terms[k];
    }
    auto hidden = zero, most = zero, own = zero;
    const auto never = one < zero;
    auto inside = never;
    for (size_t i = 0; i < count; ++i) {
      const BlockingPolygon<T>& b = blocking[i];
      if (b.first) {
        own = hn::IfThenElse(inside, whole, own);
        hidden = hidden + own, most = hn::Max(most, own);
        own = zero;
        inside = b.closed ? hn::Not(never) : never;
      }
      const auto height = height_over(d, b, x);
      const auto front = height > edge_on, back = height < hn::Neg(edge_on);
      inside = hn::And(inside, back);
      const auto hides = b.two_sided ? hn::Or(front, back) : front;
      if (b.count < 3 || hn::AllFalse(d, hides)) continue;
      Pyramid<D> pyramid;
      if (look_past(d, source, x, b, hn::IfThenElse(front, one, hn::Neg(one)), pyramid))
        own = own + hn::IfThenElseZero(hides, covered(d, source, n, pyramid));
    }
    own = hn::IfThenElse(inside, whole, own);
    hidden = hidden + own, most = hn::Max(most, own);
    whole = hn::Max(whole, zero);
    const auto scale = hn::Load(d, points.areas + lane) * hn::Set(d, T(1 / kTwoPi));
    whole = whole * scale;
    const auto low = hn::Max(whole - hidden * scale, zero), high = hn::Max(whole - most * scale, zero);
    hn::Store(whole, d, seen.whole + lane);
    hn::Store(low, d, seen.low + lane);
    hn::Store(high, d, seen.high + lane);
    whole_sum = whole_sum + whole, low_sum = low_sum + low, high_sum = high_sum + high;
  }
  seen.all = {double(hn::GetLane(hn::SumOfLanes(d, whole_sum))), double(hn::GetLane(hn::SumOfLanes(d, low_sum))),
              double(hn::GetLane(hn::SumOfLanes(d, high_sum)))};
}

/// Whether a source side has all of the polygon beyond it.
template <class D>
HWY_INLINE bool is_beside(D d, const View<D>& source, const Pyramid<D>& polygon) {
  for (int e = 0; e < source.count; ++e) {
    const auto side = cross(source.corners[e + 1 == source.count ? 0 : e + 1], source.corners[e]);
    auto highest = hn::Zero(d);
    for (int k = 0; k < polygon.count; ++k) highest = hn::Max(highest, dot(side, polygon.corners[k]));
    if (hn::AllFalse(d, highest > hn::Zero(d))) return true;
  }
  return false;
}

template <class T>
HWY_INLINE bool MayHideAny(const PointLanes<T>& points, const SourcePolygon<T>& polygon,
                           const BlockingPolygon<T>* blocking, size_t count) {
  const hn::CappedTag<T, kLeaf> d;
  using D = std::remove_const_t<decltype(d)>;
  const auto one = hn::Set(d, T(1)), edge_on = hn::Set(d, kEdgeOn<T>);
  for (size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    const auto x = points_at(d, points, lane);
    View<D> source;
    place(d, polygon, x, source);
    for (size_t i = 0; i < count; ++i) {
      const BlockingPolygon<T>& b = blocking[i];
      const auto height = height_over(d, b, x);
      const auto front = height > edge_on, back = height < hn::Neg(edge_on);
      if (b.closed && !hn::AllFalse(d, back)) return true;  // it may be inside
      const auto hides = b.two_sided ? hn::Or(front, back) : front;
      if (b.count < 3 || hn::AllFalse(d, hides)) continue;
      Pyramid<D> pyramid;
      if (look_past(d, source, x, b, hn::IfThenElse(front, one, hn::Neg(one)), pyramid) &&
          !is_beside(d, source, pyramid))
        return true;
    }
  }
  return false;
}

uint32_t BlockedLanes(const float* receiver, const float* sources, size_t bounds, size_t surface, float tolerance,
                      uint32_t lanes) {
  const hn::CappedTag<float, kLeaf> d;
  const auto zero = hn::Zero(d), never = hn::Set(d, 2.0F);
  uint32_t blocked = 0;
  for (size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    auto open = never < zero;  // some segment is not stopped
    for (size_t p = 0; p < 4; ++p)
      for (size_t q = 0; q < 4; ++q) {
        auto from = zero, to = hn::Set(d, 1.0F);
        for (size_t k = 0; k < bounds; ++k) {
          const auto outside = hn::Set(d, k < surface ? -tolerance : tolerance);
          const auto a = hn::Set(d, receiver[(4 * k + p) * kLeaf]);
          const auto b = hn::LoadU(d, sources + (4 * k + q) * kLeaf + lane);
          from = hn::IfThenElse(hn::And(a > outside, b > outside), never, from);
          const auto t = quotient(d, a, a - b);
          from = hn::IfThenElse(hn::And(a > zero, b <= zero), hn::Max(from, t), from);
          to = hn::IfThenElse(hn::And(a <= zero, b > zero), hn::Min(to, t), to);
        }
        open = hn::Or(open, from + hn::Set(d, 1e-6F) > to);
        if (hn::AllTrue(d, open)) p = q = 4;
      }
    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Not(open), bits);
    blocked |= (uint32_t(bits[0]) | uint32_t(bits[1]) << 8) << lane;
  }
  return blocked & lanes;
}

void LanesFloat(const SourceLanes<float>& sources, const ReceiverPoint<float>* points, size_t count, const float* n,
                float* sums) {
  LanesOf(sources, points, count, n, sums);
}
void LanesDouble(const SourceLanes<double>& sources, const ReceiverPoint<double>* points, size_t count, const double* n,
                 double* sums) {
  LanesOf(sources, points, count, n, sums);
}
void LookFloat(const PointLanes<float>& points, const float* n, const SourcePolygon<float>& source,
               const BlockingPolygon<float>* blocking, size_t count, Seen<float>& seen) {
  LookAt(points, n, source, blocking, count, seen);
}
void LookDouble(const PointLanes<double>& points, const double* n, const SourcePolygon<double>& source,
                const BlockingPolygon<double>* blocking, size_t count, Seen<double>& seen) {
  LookAt(points, n, source, blocking, count, seen);
}

bool MayHideFloat(const PointLanes<float>& points, const SourcePolygon<float>& source,
                  const BlockingPolygon<float>* blocking, size_t count) {
  return MayHideAny(points, source, blocking, count);
}
bool MayHideDouble(const PointLanes<double>& points, const SourcePolygon<double>& source,
                   const BlockingPolygon<double>* blocking, size_t count) {
  return MayHideAny(points, source, blocking, count);
}

}  // namespace HWY_NAMESPACE
}  // namespace aktina
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {
namespace {
HWY_EXPORT(LanesFloat);
HWY_EXPORT(LanesDouble);
HWY_EXPORT(LookFloat);
HWY_EXPORT(LookDouble);
HWY_EXPORT(MayHideFloat);
HWY_EXPORT(MayHideDouble);
HWY_EXPORT(BlockedLanes);
}  // namespace

void add_lanes(const SourceLanes<float>& sources, const ReceiverPoint<float>* points, size_t count, const float n[3],
               float sums[kLeaf]) {
  HWY_DYNAMIC_DISPATCH(LanesFloat)(sources, points, count, n, sums);
}
void add_lanes(const SourceLanes<double>& sources, const ReceiverPoint<double>* points, size_t count, const double n[3],
               double sums[kLeaf]) {
  HWY_DYNAMIC_DISPATCH(LanesDouble)(sources, points, count, n, sums);
}
void look(const PointLanes<float>& points, const float n[3], const SourcePolygon<float>& source,
          const BlockingPolygon<float>* blocking, size_t count, Seen<float>& seen) {
  HWY_DYNAMIC_DISPATCH(LookFloat)(points, n, source, blocking, count, seen);
}
void look(const PointLanes<double>& points, const double n[3], const SourcePolygon<double>& source,
          const BlockingPolygon<double>* blocking, size_t count, Seen<double>& seen) {
  HWY_DYNAMIC_DISPATCH(LookDouble)(points, n, source, blocking, count, seen);
}
bool may_hide(const PointLanes<float>& points, const SourcePolygon<float>& source,
              const BlockingPolygon<float>* blocking, size_t count) {
  return HWY_DYNAMIC_DISPATCH(MayHideFloat)(points, source, blocking, count);
}
bool may_hide(const PointLanes<double>& points, const SourcePolygon<double>& source,
              const BlockingPolygon<double>* blocking, size_t count) {
  return HWY_DYNAMIC_DISPATCH(MayHideDouble)(points, source, blocking, count);
}
uint32_t blocked_lanes(const float* receiver, const float* sources, size_t bounds, size_t surface, float tolerance,
                       uint32_t lanes) {
  return HWY_DYNAMIC_DISPATCH(BlockedLanes)(receiver, sources, bounds, surface, tolerance, lanes);
}

}  // namespace aktina
#endif
