// J. Amanatides, K. Choi, "Ray Tracing Triangular Meshes", Western Computer Graphics Symposium, 1997 (Pluecker test).
#include "aktina/trace/triangle_soup.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aktina/trace/triangle_soup_simd.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace aktina {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, kPacket>;
using IntTag = hn::Rebind<int32_t, Tag>;
using F = hn::Vec<Tag>;
constexpr Tag f32;
constexpr IntTag i32;

/// Lanes(f32) rays in registers.
struct Rays {
  F origin[3], direction[3], moment[3];  // moment: 2 origin x direction
  F near, far;

  Rays(const RayPacket& packet, size_t first, Point3 centre) {
    for (int k = 0; k < 3; ++k) {
      origin[k] = hn::Load(f32, packet.origin[k] + first) - hn::Set(f32, centre[k]);
      direction[k] = hn::Load(f32, packet.direction[k] + first);
    }
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      const F m = origin[a] * direction[b] - origin[b] * direction[a];
      moment[k] = m + m;
    }
    near = hn::Load(f32, packet.near + first);
    far = hn::Load(f32, packet.far + first);
  }
};

F dot(const F a[3], const float b[3]) {
  return hn::MulAdd(a[0], hn::Set(f32, b[0]), hn::MulAdd(a[1], hn::Set(f32, b[1]), a[2] * hn::Set(f32, b[2])));
}

/// Which rays meet the triangle, where, and the weights (times `sum`) of vertices 1 and 2.
struct Meeting {
  hn::Mask<Tag> hit;
  F t, w1, w2, sum;

  Meeting(const Rays& rays, const SoupTriangle& triangle) {
    F w[3];
    for (int k = 0; k < 3; ++k) w[k] = dot(rays.direction, triangle.moment[k]) - dot(rays.moment, triangle.edge[k]);
    const F zero = hn::Zero(f32);
    const F least = hn::Min(hn::Min(w[0], w[1]), w[2]), most = hn::Max(hn::Max(w[0], w[1]), w[2]);
    w1 = w[1], w2 = w[2];
    sum = w[0] + w[1] + w[2];  // -2 normal . direction
    const F height = hn::Set(f32, triangle.offset) - dot(rays.origin, triangle.normal);
    t = height * hn::Set(f32, -2.0f) / sum;
    // All weights of one sign: from either side. sum = 0 (a ray in the plane) gives an infinite or undefined t: no hit.
    hit = hn::And(hn::Or(least >= zero, most <= zero), hn::And(t > rays.near, t < rays.far));
  }
};

void IntersectPacket(const SoupTriangle* triangles, size_t count, Point3 centre, const RayPacket& packet,
                     uint32_t lanes, HitPacket& hits) {
  for (size_t first = 0; first < size_t(kPacket); first += hn::Lanes(f32)) {
    if ((lanes >> first & ((1U << hn::Lanes(f32)) - 1)) == 0) continue;
    Rays rays(packet, first, centre);
    F w1 = hn::Zero(f32), w2 = hn::Zero(f32), sum = hn::Set(f32, 1);
    auto nearest = hn::Set(i32, -1);
    for (size_t i = 0; i < count; ++i) {
      const Meeting m(rays, triangles[i]);
      if (hn::AllFalse(f32, m.hit)) continue;
      rays.far = hn::IfThenElse(m.hit, m.t, rays.far);
      w1 = hn::IfThenElse(m.hit, m.w1, w1), w2 = hn::IfThenElse(m.hit, m.w2, w2);
      sum = hn::IfThenElse(m.hit, m.sum, sum);
      nearest = hn::IfThenElse(hn::RebindMask(i32, m.hit), hn::Set(i32, int32_t(i)), nearest);
    }
    HWY_ALIGN float t[kPacket], u[kPacket], v[kPacket];
    HWY_ALIGN int32_t index[kPacket];
    hn::Store(rays.far, f32, t), hn::Store(w1 / sum, f32, u), hn::Store(w2 / sum, f32, v);
    hn::Store(nearest, i32, index);
    for (size_t i = 0; i < hn::Lanes(f32); ++i) {
      if ((lanes >> (first + i) & 1) == 0) continue;
      Hit hit;
      if (index[i] >= 0) {
        const SoupTriangle& s = triangles[index[i]];
        hit = {t[i], s.side * Vec3(s.normal[0], s.normal[1], s.normal[2]), u[i], v[i], s.triangle, s.instance};
      }
      hits.set(int(first + i), hit);
    }
  }
}

uint32_t OccludedPacket(const SoupTriangle* triangles, size_t count, Point3 centre, const RayPacket& packet,
                        uint32_t lanes) {
  uint32_t blocked = 0;
  for (size_t first = 0; first < size_t(kPacket); first += hn::Lanes(f32)) {
    const uint32_t wanted = lanes >> first & ((1U << hn::Lanes(f32)) - 1);
    if (wanted == 0) continue;
    const Rays rays(packet, first, centre);
    uint32_t bits = 0;
    for (size_t i = 0; i < count && (bits & wanted) != wanted; ++i) {
      const Meeting m(rays, triangles[i]);
      if (hn::AllFalse(f32, m.hit)) continue;
      uint8_t bytes[8] = {};
      hn::StoreMaskBits(f32, m.hit, bytes);
      bits |= bytes[0] | uint32_t(bytes[1]) << 8;
    }
    blocked |= (bits & wanted) << first;
  }
  return blocked;
}

}  // namespace HWY_NAMESPACE
}  // namespace aktina
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aktina {
namespace {
HWY_EXPORT(IntersectPacket);
HWY_EXPORT(OccludedPacket);

void store(float to[3], Vec3 from) { to[0] = from.x, to[1] = from.y, to[2] = from.z; }
}  // namespace

void TriangleSoup::add(Point3 a, Point3 b, Point3 c, float side, uint32_t triangle, uint32_t instance) {
  const Vec3 normal = cross(b - a, c - a);
  if (is_finite(normal) && squared_length(normal) > 0) corners_.push_back({{a, b, c}, side, triangle, instance});
}

void TriangleSoup::finish() {
  Bounds box;
  for (const Corners& c : corners_)
    for (const Point3& p : c.p) box.add(p);
  centre_ = box.empty() ? Point3(0) : box.centre();
  for (const Corners& c : corners_) {
    SoupTriangle t;
    const Point3 p[3] = {c.p[0] - centre_, c.p[1] - centre_, c.p[2] - centre_};
    for (int k = 0; k < 3; ++k) {
      const Point3 from = p[(k + 1) % 3], to = p[(k + 2) % 3];
      store(t.edge[k], to - from);
      store(t.moment[k], cross(to - from, to + from));
    }
    const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
    store(t.normal, normal);
    t.offset = dot(normal, p[0]);
    t.side = c.side, t.triangle = c.triangle, t.instance = c.instance;
    triangles_.push_back(t);
  }
  corners_ = {};
}

void TriangleSoup::intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits) const {
  HWY_DYNAMIC_DISPATCH(IntersectPacket)(triangles_.data(), triangles_.size(), centre_, rays, lanes, hits);
}

uint32_t TriangleSoup::occluded(const RayPacket& rays, uint32_t lanes) const {
  return HWY_DYNAMIC_DISPATCH(OccludedPacket)(triangles_.data(), triangles_.size(), centre_, rays, lanes);
}

}  // namespace aktina
#endif
