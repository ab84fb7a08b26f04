#include <algorithm>
#include <bit>

#include "aktina/raster/band.h"

namespace aktina {
namespace {

void clear_spans(const RasterFrame& frame, size_t size, SpanBuffers& out) {
  for (int k = 0; k < 3; ++k) out.diffuse[k].resize(size), out.specular[k].resize(size);
  if (!frame.pipelines.any_blended) return;
  out.blended.resize(size);
  std::fill_n(out.blended.data(), size, kNobody);
}

/// The slow path of alpha masks: each covered pixel asks the texture.
void draw_masked(const RasterFrame& frame, const TriangleChunk& chunk, uint32_t first_name,
                 std::span<const uint32_t> list, RasterBand& band) {
  for (const uint32_t n : list)
    visit_nearer(chunk.records[n], band.visible, [&](int x, int y, uint32_t bits, const float* depth) {
      for (; bits != 0; bits &= bits - 1) {
        const int i = std::countr_zero(bits);
        if (!passes_mask(frame, first_name + n, x + (i & 3), y + (i >> 2), depth[i])) continue;
        const size_t at = band.visible.layout.offset(x, y) + size_t(i);
        band.visible.depth[at] = depth[i], band.visible.seen[at] = first_name + n;
      }
    });
}

void draw_run(const RasterFrame& frame, uint32_t index, uint32_t pipeline_index, std::span<const uint32_t> list,
              RasterBand& band) {
  const TriangleChunk& chunk = frame.chunks[index];
  const Pipeline& pipeline = frame.pipelines.all[pipeline_index];
  const uint32_t first_name = index << kChunkBits;
  if (pipeline.immediate) {
    draw_immediate(chunk, pipeline, frame.stride(), frame.view.perspective(), list, band);
  } else if (pipeline.masked()) {
    draw_masked(frame, chunk, first_name, list, band);
  } else {
    draw_deferred(chunk, first_name, list, band);
  }
}

void draw_visible(const RasterFrame& frame, int index, RasterBand& band) {
  for (uint32_t c = 0; c < frame.chunks.size(); ++c) {
    const TriangleChunk& chunk = frame.chunks[c];
    std::span<const uint32_t> left = chunk.bands[size_t(index)];
    for (size_t run = 0; run < chunk.runs.size() && !left.empty(); ++run) {
      const uint32_t end = run + 1 < chunk.runs.size() ? chunk.runs[run + 1].first : chunk.count;
      const auto count = size_t(std::lower_bound(left.begin(), left.end(), end) - left.begin());
      if (count > 0) draw_run(frame, c, chunk.runs[run].pipeline, left.first(count), band);
      left = left.subspan(count);
    }
  }
}

}  // namespace

/// Colours stay as they are: where nothing is seen they say nothing.
void clear_band(const RasterFrame& frame, int index, RasterBand& band) {
  const int first = index * kBandRows;
  band.names = frame.pipelines.any_deferred;
  band.visible.clear({first, std::min(kBandRows, frame.view.height() - first), frame.view.width()},
                     frame.view.farthest(), band.names);
  const size_t size = band.visible.layout.blocks() * kLanes;
  if (frame.pipelines.any_spans) clear_spans(frame, size, band.on_spans);
  for (int k = 0; k < 3; ++k) {
    band.colour[k].resize(size);
    if (!band.surface_layers) continue;
    band.albedo[k].resize(size), band.normal[k].resize(size);
    std::fill_n(band.albedo[k].data(), size, 0.0f), std::fill_n(band.normal[k].data(), size, 0.0f);
  }
}

void draw_opaque(const RasterFrame& frame, int index, RasterBand& band) {
  LineArray<uint32_t>& seen = band.visible.seen;
  if (band.names && frame.first_chunk > 0) std::fill_n(seen.data(), band.visible.layout.blocks() * kLanes, kNobody);
  draw_visible(frame, index, band);
  if (frame.pipelines.any_spans) shade_spans(frame, index, band);
  if (band.names) shade_opaque(frame, band);
}

void finish_band(const RasterFrame& frame, int index, const Background& background, RasterBand& band) {
  band.filled = background.varies || background.fill || frame.pipelines.any_blended;
  if (band.filled) fill_background(frame, background, band);
  if (frame.pipelines.any_blended) draw_blended(frame, index, band);
}

void fill_background(const RasterFrame& frame, const Background& background, RasterBand& band) {
  const BlockLayout& layout = band.visible.layout;
  for (int y = layout.first_row; y < layout.first_row + layout.rows; ++y)
    for (int x = 0; x < layout.width; ++x) {
      const size_t at = layout.offset_of_pixel(x, y);
      if (band.visible.depth[at] > frame.view.farthest()) continue;
      const Rgb c = background.varies ? background.at(x, y) : background.uniform;
      for (int k = 0; k < 3; ++k) band.colour[k][at] = c[k];
    }
}

}  // namespace aktina
