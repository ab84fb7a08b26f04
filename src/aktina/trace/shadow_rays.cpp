#include "aktina/trace/shadow_rays.h"

#include <algorithm>
#include <array>

#include "aktina/trace/offset.h"

namespace aktina {
namespace {
constexpr int kMostLayers = 64;  // surfaces that a shadow ray looks through, at most
}

Ray shadow_ray(Point3 from, Point3 target, bool distant) {
  if (distant) return {from, target, 0, kInfinity};
  return {from, target - from, 0, 1};
}

bool ShadowRays::may_pass(const RayScene& scene, const ShadowRay& ray) const {
  return clear_bodies_ || scene.surfaces.any_alpha() || ray.ignored != kNothing;
}

/// Goes from surface to surface.
void ShadowRays::attenuate(const RayScene& scene, ShadowRay& shadow) const {
  std::vector<uint32_t> crossed;
  Ray ray = shadow.ray;
  for (int layer = 0; layer < kMostLayers; ++layer) {
    const Hit hit = scene.accelerator->intersect(ray);
    if (!hit) return;
    if (hit.instance != shadow.ignored) {
      const float through = 1 - scene.surfaces.alpha(ray, hit);
      Rgb clear;
      if (clear_bodies_) {
        const bool again = std::find(crossed.begin(), crossed.end(), hit.instance) != crossed.end();
        clear = again ? Rgb(1) : scene.surfaces.transmission(ray, hit);
        crossed.push_back(hit.instance);
      }
      shadow.light *= Rgb(through) + clear * (1 - through);
      if (is_black(shadow.light)) return;
    }
    const Vec3 n = normalize_or(hit.normal, -ray.direction);
    const Point3 at = offset_point(ray.origin + hit.distance * ray.direction, dot(n, ray.direction) > 0 ? n : -n);
    if (ray.far < kInfinity) {
      const Point3 end = ray.origin + ray.direction;
      if (dot(end - at, ray.direction) <= 0) return;
      ray.direction = end - at;
    }
    ray.origin = at;
  }
  shadow.light = Rgb(0);
}

size_t ShadowRays::trace(const RayScene& scene, Coherence coherence, FunctionRef<void(const ShadowRay&)> arrived) {
  const size_t count = rays_.size();
  for (size_t first = 0; first < count; first += kPacket) {
    const size_t n = std::min(count - first, size_t(kPacket));
    RayPacket packet;
    for (size_t i = 0; i < n; ++i) packet.set(int(i), rays_[first + i].ray);
    const uint32_t blocked = scene.accelerator->occluded(packet, (1U << n) - 1, coherence);
    for (size_t i = 0; i < n; ++i) {
      ShadowRay& ray = rays_[first + i];
      if (blocked >> i & 1) {
        if (!may_pass(scene, ray)) continue;
        attenuate(scene, ray);
        if (is_black(ray.light)) continue;
      }
      arrived(ray);
    }
  }
  rays_.clear();
  return count;
}

}  // namespace aktina
