// A wave of rays, traced in packets.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "aktina/trace/ray_scene.h"

namespace aktina {

/// Calls met(i, hit) for each of the rays, in order. @param ray_of  index -> Ray
template <class RayOf, class Met>
void trace_wave(const Accelerator& accelerator, size_t count, Coherence coherence, RayOf&& ray_of, Met&& met) {
  RayPacket packet;
  HitPacket hits;
  for (size_t first = 0; first < count; first += kPacket) {
    const size_t n = std::min(count - first, size_t(kPacket));
    for (size_t i = 0; i < n; ++i) packet.set(int(i), ray_of(first + i));
    accelerator.intersect(packet, (1U << n) - 1, hits, coherence);
    for (size_t i = 0; i < n; ++i) met(first + i, hits.at(int(i)));
  }
}

}  // namespace aktina
