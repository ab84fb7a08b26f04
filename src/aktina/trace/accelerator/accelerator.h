// What finds the first thing a ray meets. Virtual per packet, never per ray.
#pragma once

#include <memory>
#include <span>

#include "aktina/base/method.h"
#include "aktina/trace/ray.h"

namespace aktina {

struct Scene;

/// Whether the rays of a packet start and go together (primary rays, shadow rays to one light) or not (diffuse
/// bounces).
enum class Coherence : uint8_t { coherent, incoherent };

class Accelerator {
 public:
  virtual ~Accelerator() = default;

  /// Takes the scene's instances; the scene must outlive this and keep its geometry.
  /// @throws Error bad_input (an index beyond the vertices)
  virtual void build(const Scene& scene) = 0;

  /// Nearest hits of the lanes whose bit is set; the others are left alone. A lane that meets nothing gets an infinite
  /// distance and the instance kNothing; its other fields have no meaning. Both sides of a surface count. Of hits at
  /// exactly the same distance any may be given, but always the same one for the same packet.
  virtual void intersect(const RayPacket& rays, uint32_t lanes, HitPacket& hits, Coherence coherence) const = 0;
  /// Bits of the lanes that meet anything between near and far.
  virtual uint32_t occluded(const RayPacket& rays, uint32_t lanes, Coherence coherence) const = 0;

  /// One ray, for code that is not in a hurry.
  virtual Hit intersect(const Ray& ray) const;
  virtual bool occluded(const Ray& ray) const;
};

std::span<const Method<std::unique_ptr<Accelerator>>* const> accelerators();

/// The fastest one for this scene, built: brute force for a handful of triangles, else Embree.
std::unique_ptr<Accelerator> build_accelerator(const Scene& scene);

}  // namespace aktina
