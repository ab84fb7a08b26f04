// A wave of rays, traced in packets.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "aktina/trace/ray_scene.h"

namespace aktina {

/// Traces rays in packets and calls met(first, count, hits) for each packet, in order: lane k is ray first + k.
/// @param ray_of  index -> Ray
template <class RayOf, class Met>
void trace_wave(const Accelerator& accelerator, size_t count, Coherence coherence, RayOf&& ray_of, Met&& met) {
  RayPacket packet;
  HitPacket hits;
  for (size_t first = 0; first < count; first += kPacket) {
    const int n = int(std::min(count - first, size_t(kPacket)));
    for (int lane = 0; lane < n; ++lane) packet.set(lane, ray_of(first + size_t(lane)));
    accelerator.intersect(packet, (1U << n) - 1, hits, coherence);
    met(first, n, hits);
  }
}

}  // namespace aktina
