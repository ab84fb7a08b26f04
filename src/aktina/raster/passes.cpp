#include "aktina/raster/passes.h"

#include <algorithm>

namespace aktina {
namespace {

constexpr uint32_t kPassChunks = 32;
constexpr uint64_t kTriangleBytes = 150, kPixelBytes = 20;  // depth, name and colour

}  // namespace

uint32_t chunks_per_pass(uint32_t chunks, const Pipelines& pipelines, const View& view) {
  if (chunks <= kPassChunks || pipelines.any_blended || pipelines.any_spans) return chunks;
  const uint64_t saved = uint64_t(chunks - kPassChunks) * kChunkTriangles * kTriangleBytes;
  const uint64_t pixels = uint64_t(view.width()) * uint64_t(view.height());
  return saved > pixels * kPixelBytes ? kPassChunks : chunks;
}

}  // namespace aktina
