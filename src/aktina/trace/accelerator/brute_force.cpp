// Every primitive against every ray: the truth that other accelerators are tested against, and the fastest way where
// there are only a few triangles. Cost: linear in the number of triangles. Weakness: that.
//
// A. Appel, "Some Techniques for Shading Machine Renderings of Solids", AFIPS Spring Joint Computer Conference, 1968.
#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"
#include "aktina/trace/placed_primitive.h"
#include "aktina/trace/triangle_soup.h"

namespace aktina {
namespace {

struct Shape {
  PlacedPrimitive placed;
  uint32_t instance;
};

class BruteForce final : public Accelerator {
 public:
  void build(const Scene& scene) override;
  void intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits, Coherence coherence) const override;
  uint32_t occluded(const RayPacket& rays, uint32_t lanes, Coherence coherence) const override;

 private:
  void add(const Mesh& mesh, const Mat4& to_world, uint32_t instance);

  TriangleSoup triangles_;
  std::vector<Shape> shapes_;
};

void BruteForce::add(const Mesh& mesh, const Mat4& to_world, uint32_t instance) {
  const float side = glm::determinant(Mat3(to_world)) < 0 ? -1 : 1;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    Point3 p[3];
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t vertex = mesh.triangles[t][k];
      if (vertex >= mesh.positions.size())
        throw Error(Code::bad_input, mesh.name, fmt::format("a triangle names vertex {}", vertex),
                    fmt::format("there are {}", mesh.positions.size()));
      p[k] = transform_point(to_world, mesh.positions[vertex]);
    }
    triangles_.add(p[0], p[1], p[2], side, uint32_t(t), instance);
  }
}

void BruteForce::build(const Scene& scene) {
  triangles_ = {};
  shapes_.clear();
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (instance.mesh >= 0) add(scene.meshes[size_t(instance.mesh)], instance.to_world, uint32_t(i));
    if (instance.mesh < 0 && instance.primitive >= 0)
      shapes_.push_back({{scene.primitives[size_t(instance.primitive)], instance.to_world}, uint32_t(i)});
  }
  triangles_.finish();
}

void BruteForce::intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits, Coherence /*coherence*/) const {
  triangles_.intersect(rays, lanes, hits);
  for (const Shape& shape : shapes_)
    for (uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
      const int lane = __builtin_ctz(rest);
      Ray ray = rays.at(lane);
      ray.far = std::min(ray.far, hits.distance[lane]);
      auto hit = shape.placed.intersect(ray);
      if (!hit) continue;
      hit->instance = shape.instance;
      hits.set(lane, *hit);
    }
}

uint32_t BruteForce::occluded(const RayPacket& rays, uint32_t lanes, Coherence /*coherence*/) const {
  uint32_t blocked = triangles_.occluded(rays, lanes);
  for (const Shape& shape : shapes_)
    for (uint32_t rest = lanes & ~blocked; rest != 0; rest &= rest - 1) {
      const int lane = __builtin_ctz(rest);
      if (shape.placed.intersect(rays.at(lane))) blocked |= 1U << lane;
    }
  return blocked;
}

}  // namespace

extern constinit const Method<std::unique_ptr<Accelerator>> brute_force_accelerator = {
    {"brute_force", "Every primitive against every ray", "appel1968",
     "No hierarchy: fastest for a few dozen triangles, linear in their number beyond."},
    [](const ParamSet&) -> std::unique_ptr<Accelerator> { return std::make_unique<BruteForce>(); }};

}  // namespace aktina
