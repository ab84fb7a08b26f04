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

  HWY_INLINE Rays(const RayPacket& packet, size_t first, Point3 centre) {
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

HWY_INLINE F dot(const F (&a)[3], Vec3 b) {
  return hn::MulAdd(a[0], hn::Set(f32, b[0]), hn::MulAdd(a[1], hn::Set(f32, b[1]), a[2] * hn::Set(f32, b[2])));
}

/// Which rays meet the triangle, and where.
struct Meeting {
  hn::Mask<Tag> hit;
  F t;

  HWY_INLINE Meeting(const Rays& rays, const SoupTriangle& triangle) {
    F w[3];
    for (int k = 0; k < 3; ++k) w[k] = dot(rays.direction, triangle.moment[k]) - dot(rays.moment, triangle.edge[k]);
    const F zero = hn::Zero(f32);
    const F least = hn::Min(hn::Min(w[0], w[1]), w[2]), most = hn::Max(hn::Max(w[0], w[1]), w[2]);
    const F sum = w[0] + w[1] + w[2];  // -2 normal . direction
    const F height = hn::Set(f32, triangle.offset) - dot(rays.origin, triangle.normal);
    t = height * hn::Set(f32, -2.0f) / sum;
    // All weights of one sign: from either side. sum = 0 (a ray in the plane) gives an infinite or undefined t: no hit.
    hit = hn::And(hn::Or(least >= zero, most <= zero), hn::And(t > rays.near, t < rays.far));
  }
};

void IntersectPacket(const SoupTriangle* triangles, size_t count, Point3 centre, const RayPacket& packet,
                     uint32_t lanes, float* distance, int32_t* index) {
  for (size_t first = 0; first < size_t(kPacket); first += hn::Lanes(f32)) {
    if ((lanes >> first & ((1U << hn::Lanes(f32)) - 1)) == 0) continue;
    Rays rays(packet, first, centre);
    auto nearest = hn::Set(i32, -1);
    for (size_t i = 0; i < count; ++i) {
      const Meeting m(rays, triangles[i]);
      rays.far = hn::IfThenElse(m.hit, m.t, rays.far);
      nearest = hn::IfThenElse(hn::RebindMask(i32, m.hit), hn::Set(i32, int32_t(i)), nearest);
    }
    hn::Store(rays.far, f32, distance + first);
    hn::Store(nearest, i32, index + first);
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
      t.edge[k] = to - from;
      t.moment[k] = cross(to - from, to + from);
    }
    t.normal = cross(p[1] - p[0], p[2] - p[0]);
    t.offset = dot(t.normal, p[0]);
    t.side = c.side, t.triangle = c.triangle, t.instance = c.instance;
    triangles_.push_back(t);
  }
  corners_ = {};
}

void TriangleSoup::intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits) const {
  alignas(64) float distance[kPacket];
  alignas(64) int32_t index[kPacket];
  HWY_DYNAMIC_DISPATCH(IntersectPacket)
  (triangles_.data(), triangles_.size(), centre_, rays, lanes, distance, index);
  for (uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
    const int lane = __builtin_ctz(rest);
    Hit hit;
    if (index[lane] >= 0) {
      const Ray ray = rays.at(lane);
      const SoupTriangle& s = triangles_[size_t(index[lane])];
      const Vec3 moment = 2.0f * cross(ray.origin - centre_, ray.direction);
      float w[3];
      for (int k = 0; k < 3; ++k) w[k] = dot(ray.direction, s.moment[k]) - dot(moment, s.edge[k]);
      const float scale = 1 / (w[0] + w[1] + w[2]);
      hit = {distance[lane], s.side * s.normal, w[1] * scale, w[2] * scale, s.triangle, s.instance};
    }
    hits.set(lane, hit);
  }
}

uint32_t TriangleSoup::occluded(const RayPacket& rays, uint32_t lanes) const {
  return HWY_DYNAMIC_DISPATCH(OccludedPacket)(triangles_.data(), triangles_.size(), centre_, rays, lanes);
}

}  // namespace aktina
#endif
