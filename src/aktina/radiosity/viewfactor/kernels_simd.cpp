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
  const auto t = a / (a - b);
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

/// 2 pi times the form factor of the part of the source that the polygon covers.
/// @param seen  +1 where its front is seen, -1 its back
template <class D, class T = hn::TFromD<D>>
HWY_INLINE hn::Vec<D> covered(D d, const View<D>& source, const Three<hn::Vec<D>>& x, const Three<hn::Vec<D>>& n,
                              const BlockingPolygon<T>& polygon, hn::Vec<D> seen) {
  const auto zero = hn::Zero(d), one = hn::Set(d, T(1));
  Three<hn::Vec<D>> c[kMostBlocking];
  for (int k = 0; k < polygon.count; ++k) {
    const auto corner = spread(d, polygon.corners[k]);
    c[k] = {corner.x - x.x, corner.y - x.y, corner.z - x.z};
  }
  hn::Vec<D> from[kMostSource], to[kMostSource];
  for (int e = 0; e < source.count; ++e) from[e] = zero, to[e] = one;
  auto sum = zero;
  for (int k = 0; k < polygon.count; ++k) {
    const int next = k + 1 == polygon.count ? 0 : k + 1;
    auto side = cross(c[next], c[k]);
    side = {side.x * seen, side.y * seen, side.z * seen};
    hn::Vec<D> heights[kMostSource];
    for (int e = 0; e < source.count; ++e) heights[e] = dot(side, source.corners[e]);
    auto highest = zero;
    for (int e = 0; e < source.count; ++e) highest = hn::Max(highest, heights[e]);
    if (hn::AllFalse(d, highest > zero)) return zero;  // the source is beside the polygon for all points
    for (int e = 0; e < source.count; ++e)
      cut(d, heights[e], heights[e + 1 == source.count ? 0 : e + 1], from[e], to[e]);
    auto begin = zero, end = one;
    for (int e = 0; e < source.count; ++e)
      cut(d, dot(source.sides[e], c[k]), dot(source.sides[e], c[next]), begin, end);
    sum = sum + part(d, c[k], c[next], begin, end, side, dot(n, side));
  }
  for (int e = 0; e < source.count; ++e) {
    const int next = e + 1 == source.count ? 0 : e + 1;
    sum = sum + part(d, source.corners[e], source.corners[next], from[e], to[e], source.sides[e], source.facing[e]);
  }
  return sum;
}

template <class T>
HWY_INLINE void LookAt(const PointLanes<T>& points, const T* normal, const SourcePolygon<T>& polygon,
                       const BlockingPolygon<T>* blocking, size_t count, Seen<T>& seen) {
  const hn::CappedTag<T, kLeaf> d;
  using D = std::remove_const_t<decltype(d)>;
  using V = hn::Vec<D>;
  const T n3[3] = {normal[0], normal[1], normal[2]};
  const auto n = spread(d, n3);
  const auto zero = hn::Zero(d), one = hn::Set(d, T(1));
  const auto edge_on = hn::Set(d, sizeof(T) == 4 ? T(1e-6) : T(1e-12));
  for (size_t lane = 0; lane < kLeaf; lane += hn::Lanes(d)) {
    const Three<V> x{hn::Load(d, points.x[0] + lane), hn::Load(d, points.x[1] + lane), hn::Load(d, points.x[2] + lane)};
    View<D> source;
    source.count = polygon.count;
    for (int k = 0; k < polygon.count; ++k) {
      const auto corner = spread(d, polygon.corners[k]);
      source.corners[k] = {corner.x - x.x, corner.y - x.y, corner.z - x.z};
    }
    auto whole = zero;
    for (int k = 0; k < polygon.count; ++k) {
      const int next = k + 1 == polygon.count ? 0 : k + 1;
      const auto &a = source.corners[k], &b = source.corners[next];
      source.sides[k] = cross(b, a);
      source.facing[k] = dot(n, source.sides[k]);
      whole = whole + edge_term(d, dot(a, b), inverse_root(d, dot(a, a)), inverse_root(d, dot(b, b)), source.sides[k],
                                source.facing[k]);
    }
    auto hidden = zero, most = zero, own = zero;
    auto inside = (zero < zero);
    for (size_t i = 0; i < count; ++i) {
      const BlockingPolygon<T>& b = blocking[i];
      if (b.first) {
        own = hn::IfThenElse(inside, whole, own);
        hidden = hidden + own, most = hn::Max(most, own);
        own = zero;
        inside = b.closed ? hn::Not((zero < zero)) : (zero < zero);
      }
      const auto height = dot(spread(d, b.normal), x) - hn::Set(d, b.offset);
      const auto front = height > edge_on, back = height < hn::Neg(edge_on);
      inside = hn::And(inside, back);
      const auto hides = b.two_sided ? hn::Or(front, back) : front;
      if (b.count < 3 || hn::AllFalse(d, hides)) continue;
      const auto area = covered(d, source, x, n, b, hn::IfThenElse(front, one, hn::Neg(one)));
      own = own + hn::IfThenElseZero(hides, area);
    }
    own = hn::IfThenElse(inside, whole, own);
    hidden = hidden + own, most = hn::Max(most, own);
    const auto scale = hn::Set(d, T(1 / kTwoPi));
    hn::Store(whole * scale, d, seen.whole + lane);
    hn::Store(hidden * scale, d, seen.hidden + lane);
    hn::Store(most * scale, d, seen.most + lane);
  }
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

}  // namespace aktina
#endif
