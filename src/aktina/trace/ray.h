// Rays and hits, in packets of sixteen: what every accelerator takes and gives.
#pragma once

#include <cstdint>

#include "aktina/base/vec.h"

namespace aktina {

inline constexpr int kPacket = 16;
inline constexpr uint32_t kAllLanes = 0xffff;
inline constexpr uint32_t kNothing = 0xffffffff;

struct Ray {
  Point3 origin;
  Vec3 direction;  // distances are in units of its length
  float near = 0;  // open interval (near, far)
  float far = kInfinity;
};

struct Hit {
  float distance = kInfinity;
  Vec3 normal{0};         // geometric, world, not unit; points to the front side
  float u = 0, v = 0;     // barycentrics of vertices 1 and 2 (triangles); 0 for primitives, see PlacedPrimitive::uv
  uint32_t triangle = 0;  // within the mesh; 0 for primitives
  uint32_t instance = kNothing;  // index into Scene::instances; kNothing: no hit
  explicit operator bool() const { return instance != kNothing; }
};

struct alignas(64) RayPacket {
  float origin[3][kPacket], direction[3][kPacket];
  float near[kPacket], far[kPacket];
  void set(int lane, const Ray& ray) {
    for (int k = 0; k < 3; ++k) origin[k][lane] = ray.origin[k], direction[k][lane] = ray.direction[k];
    near[lane] = ray.near, far[lane] = ray.far;
  }
  Ray at(int lane) const {
    return {{origin[0][lane], origin[1][lane], origin[2][lane]},
            {direction[0][lane], direction[1][lane], direction[2][lane]},
            near[lane],
            far[lane]};
  }
};

struct alignas(64) HitPacket {
  float distance[kPacket];
  float normal[3][kPacket];
  float u[kPacket], v[kPacket];
  uint32_t triangle[kPacket], instance[kPacket];
  Hit at(int lane) const {
    return {distance[lane], {normal[0][lane], normal[1][lane], normal[2][lane]}, u[lane], v[lane], triangle[lane],
            instance[lane]};
  }
  void set(int lane, const Hit& hit) {
    distance[lane] = hit.distance, u[lane] = hit.u, v[lane] = hit.v;
    for (int k = 0; k < 3; ++k) normal[k][lane] = hit.normal[k];
    triangle[lane] = hit.triangle, instance[lane] = hit.instance;
  }
};

}  // namespace aktina
