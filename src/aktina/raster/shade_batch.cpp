// Visible pixels of deferred pipelines, lit many at a time.
#include <algorithm>
#include <bit>

#include "aktina/illumination/ggx.h"
#include "aktina/raster/band.h"

namespace aktina {
namespace {

/// What shade_spans() left of the pixels of a batch.
void fetch_spans(const RasterBand& band, ShadeBatch& b) {
  for (size_t block = 0; block < b.blocks; ++block) {
    const size_t from = band.visible.layout.offset(b.x[block], b.y[block]), to = block * kLanes;
    for (int k = 0; k < 3; ++k) {
      std::copy_n(band.on_spans.diffuse[k].data() + from, kLanes, b.diffuse[k] + to);
      std::copy_n(band.on_spans.specular[k].data() + from, kLanes, b.specular[k] + to);
    }
  }
}

void fetch_colour(const Pipeline& pipeline, ShadeBatch& b) {
  for (int k = 0; k < 3; ++k)
    for (size_t i = 0; i < b.blocks * kLanes; ++i) {
      b.diffuse[k][i] = pipeline.lit ? std::max(b.channel[k][i], 0.0f) : 0;  // polynomials swing below zero
      b.specular[k][i] = pipeline.lit ? std::max(b.channel[3 + k][i], 0.0f) : 0;
    }
}

/// What was lit as if white, with the coefficients that textures have given. The highlight is as wide as the material's
/// own exponent makes it: it gets the energy, not the height, of the one that its textures ask for.
void colour_blank(const Pipeline& pipeline, ShadeBatch& b) {
  const bool physical = std::holds_alternative<Ggx>(pipeline.light.model());
  const Surface& blank = pipeline.light.surface();
  const Rgb ambient = pipeline.light.ambient(), coat = normal_reflectance(blank);
  for (size_t i = 0; i < b.blocks * kLanes; ++i) {
    Rgb kd(b.kd[0][i], b.kd[1][i], b.kd[2][i]), ks(b.ks[0][i], b.ks[1][i], b.ks[2][i]);
    ks *= (2 * std::max(blank.exponent, 0.0f) + 1) / (2 * std::max(b.exponent[i], 0.0f) + 1);
    if (physical && b.seen[i] != kNobody) {
      const Surface& s = b.whole[i];
      const Rgb f0 = normal_reflectance(s);
      kd = s.base * (1 - s.metallic);
      for (int k = 0; k < 3; ++k) ks[k] = coat[k] > 0 ? f0[k] / coat[k] : 0;
    }
    for (int k = 0; k < 3; ++k) {
      b.diffuse[k][i] = b.ka[k][i] * ambient[k] + kd[k] * b.diffuse[k][i];
      b.specular[k][i] *= ks[k];
    }
  }
}

void light(const Pipeline& pipeline, RasterBand& band) {
  ShadeBatch& b = band.batch;
  const size_t count = b.blocks * kLanes;
  const LitArrays out{{b.diffuse[0], b.diffuse[1], b.diffuse[2]}, {b.specular[0], b.specular[1], b.specular[2]}};
  if (pipeline.lit && pipeline.plan.kind == ShadingPlan::Kind::attributes) {
    const float* channels[kMostChannels];
    for (int c = 0; c < kMostChannels; ++c) channels[c] = b.channel[c];
    const SurfaceArrays surface{{b.ka[0], b.ka[1], b.ka[2]},
                                {b.kd[0], b.kd[1], b.kd[2]},
                                {b.ks[0], b.ks[1], b.ks[2]},
                                b.exponent,
                                pipeline.light.reads_whole_surface() ? b.whole.data() : nullptr};
    const Fragments fragments{
        count, channels, {b.position[0], b.position[1], b.position[2]}, pipeline.textured ? &surface : nullptr};
    pipeline.method->shade(fragments, pipeline.light, out);
    return;
  }
  if (pipeline.spans()) {
    fetch_spans(band, b);
  } else {
    fetch_colour(pipeline, b);
  }
  if (!pipeline.lit) return;
  colour_blank(pipeline, b);
}

void emit_plain(const RasterFrame& frame, const Pipeline& pipeline, ShadeBatch& b) {
  const bool both = pipeline.emits_on(false), dark = is_black(pipeline.emission);
  for (size_t i = 0; i < b.blocks * kLanes; ++i) {
    const bool shines = !dark && b.seen[i] != kNobody && (both || frame.source(b.seen[i]).front);
    for (int k = 0; k < 3; ++k) b.emission[k][i] = shines ? pipeline.emission[k] : 0;
  }
}

void write(const Pipeline& pipeline, const ShadeBatch& b, RasterBand& band) {
  const bool blended = pipeline.blended(), layers = band.surface_layers && !blended;
  for (size_t block = 0; block < b.blocks; ++block) {
    const size_t to = band.visible.layout.offset(b.x[block], b.y[block]), from = block * kLanes;
    for (int k = 0; k < 3; ++k) {
      float* colour = band.colour[k].data() + to;
      for (size_t i = 0; i < kLanes; ++i) {
        const size_t j = from + i;
        const float c = b.diffuse[k][j] + b.specular[k][j] + b.emission[k][j];
        const float value = blended ? colour[i] + b.alpha[j] * (c - colour[i]) : c;
        colour[i] = b.seen[j] != kNobody ? value : colour[i];
      }
      for (size_t i = 0; i < kLanes && layers; ++i) {
        if (b.seen[from + i] == kNobody) continue;
        band.albedo[k][to + i] = b.albedo[k][from + i], band.normal[k][to + i] = b.normal[k][from + i];
      }
    }
  }
}

/// Shades the blocks that wait.
void flush(const RasterFrame& frame, RasterBand& band) {
  ShadeBatch& b = band.batch;
  if (b.blocks == 0) return;
  const Pipeline& pipeline = frame.pipelines.all[b.pipeline];
  interpolate(frame, pipeline, b);
  if (pipeline.textured) {
    apply_textures(frame, pipeline, band.surface_layers, b);
  } else {
    emit_plain(frame, pipeline, b);
  }
  light(pipeline, band);
  write(pipeline, b, band);
  b.blocks = 0;
}

/// Makes room for a block of a pipeline. @return  its first pixel in the batch
size_t add_block(const RasterFrame& frame, uint32_t pipeline, int x, int y, RasterBand& band) {
  ShadeBatch& b = band.batch;
  if (b.blocks == ShadeBatch::kBlocks || (b.blocks > 0 && b.pipeline != pipeline)) flush(frame, band);
  b.pipeline = pipeline;
  b.x[b.blocks] = x, b.y[b.blocks] = y;
  return b.blocks++ * kLanes;
}

uint32_t next_pipeline(const RasterFrame& frame, const uint32_t* seen, int after) {
  int next = INT32_MAX;
  for (size_t i = 0; i < kLanes; ++i) {
    if (seen[i] == kNobody) continue;
    const int pipeline = frame.source(seen[i]).pipeline;
    if (pipeline > after) next = std::min(next, pipeline);
  }
  return uint32_t(next);
}

void shade_block(const RasterFrame& frame, int x, int y, RasterBand& band) {
  const size_t at = band.visible.layout.offset(x, y);
  const uint32_t* seen = band.visible.seen.data() + at;
  if (std::all_of(seen, seen + kLanes, [](uint32_t name) { return name == kNobody; })) return;
  const bool single = frame.pipelines.all.size() == 1;
  for (uint32_t pipeline = single ? 0 : next_pipeline(frame, seen, -1); pipeline < frame.pipelines.all.size();
       pipeline = single ? ~0U : next_pipeline(frame, seen, int(pipeline))) {
    const size_t first = add_block(frame, pipeline, x, y, band);
    std::copy_n(band.visible.depth.data() + at, kLanes, band.batch.depth + first);
    for (size_t i = 0; i < kLanes; ++i) {
      const bool own = seen[i] != kNobody && (single || frame.source(seen[i]).pipeline == pipeline);
      band.batch.seen[first + i] = own ? seen[i] : kNobody;
    }
  }
}

void shade_blended_spans(const RasterFrame& frame, uint32_t name, RasterBand& band) {
  uint32_t* const who = band.on_spans.blended.data();
  visit_nearer(frame.record(name), band.visible, [&](int x, int y, uint32_t bits, const float*) {
    uint32_t* block = who + band.visible.layout.offset(x, y);
    for (; bits != 0; bits &= bits - 1) block[std::countr_zero(bits)] = name;
  });
  shade_spans_of(frame, name, who, band);
}

}  // namespace

void shade_opaque(const RasterFrame& frame, RasterBand& band) {
  const BlockLayout& layout = band.visible.layout;
  for (int y = layout.first_row; y < layout.first_row + layout.rows; y += kBlock)
    for (int x = 0; x < layout.width; x += kBlock) shade_block(frame, x, y, band);
  flush(frame, band);
}

void draw_blended(const RasterFrame& frame, int index, RasterBand& band) {
  band.blended.clear();
  for (uint32_t c = 0; c < frame.chunks.size(); ++c)
    for (const TriangleChunk::Blended& b : frame.chunks[c].blended[size_t(index)])
      band.blended.emplace_back(c << kChunkBits | b.record, b.depth);
  std::stable_sort(band.blended.begin(), band.blended.end(),
                   [](const auto& a, const auto& b) { return a.second < b.second; });  // farthest first
  for (const auto& [name, depth] : band.blended) {
    const bool spans = frame.pipelines.all[frame.source(name).pipeline].spans();
    if (spans) shade_blended_spans(frame, name, band);
    visit_nearer(frame.record(name), band.visible, [&, who = name](int x, int y, uint32_t bits, const float* z) {
      const size_t first = add_block(frame, frame.source(who).pipeline, x, y, band);
      std::copy_n(z, kLanes, band.batch.depth + first);
      for (size_t i = 0; i < kLanes; ++i) band.batch.seen[first + i] = bits >> i & 1 ? who : kNobody;
    });
    if (spans) flush(frame, band);  // before another's light takes the place of this one's
  }
  flush(frame, band);
}

}  // namespace aktina
