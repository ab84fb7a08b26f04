// A band of rows in the making: what one thread works in.
#pragma once

#include <array>

#include "aktina/base/function_ref.h"
#include "aktina/raster/raster_frame.h"
#include "aktina/raster/visibility.h"

namespace aktina {

/// Blocks of one pipeline that wait to be shaded together.
struct ShadeBatch {
  static constexpr size_t kBlocks = 16, kPixels = kBlocks * kLanes;
  size_t blocks = 0;
  uint32_t pipeline = 0;
  int x[kBlocks], y[kBlocks];
  alignas(64) uint32_t seen[kPixels];  // names of records; kNobody where this batch has nothing to do
  alignas(64) float depth[kPixels], position[3][kPixels], surface[2][kPixels], channel[kMostChannels][kPixels];
  alignas(64) float diffuse[3][kPixels], specular[3][kPixels], emission[3][kPixels];
  // of textured pipelines
  alignas(64) float ka[3][kPixels], kd[3][kPixels], ks[3][kPixels], exponent[kPixels], alpha[kPixels];
  alignas(64) float albedo[3][kPixels], normal[3][kPixels];
  std::vector<Surface> whole;  // kPixels, where the illumination model reads more than ka, kd, ks and exponent
};

/// Visible pixels of methods on spans: names of records, and what they show. In blocks, as the visibility buffer.
struct SpanBuffers {
  LineArray<uint32_t> blended;                       // who shades a pixel of a surface that is seen through
  LineArray<float> diffuse[3], specular[3];          // of textured and blended pipelines, until textures have their say
  std::vector<Span> spans;                           // that wait to be shaded,
  LineArray<float> lit_diffuse[3], lit_specular[3];  // and where they are: one after the other
  size_t used = 0;
};

struct RasterBand {
  VisibilityBuffer visible;
  LineArray<float> colour[3], albedo[3], normal[3];  // albedo and normal: only where layers ask for them
  bool surface_layers = false;
  bool names = false;  // some pipeline of the frame is deferred: `seen` is kept
  bool filled = true;  // colour is there also where nothing is seen; else it says nothing there
  ShadeBatch batch;
  SpanBuffers on_spans;
  std::vector<std::pair<uint32_t, float>> blended;  // names and depths
};

/// Draws records `list` (places in a chunk) of an immediate pipeline: depth and colour, and nobody into `seen`.
void draw_immediate(const TriangleChunk& chunk, const Pipeline& pipeline, size_t stride, bool perspective_view,
                    std::span<const uint32_t> list, RasterBand& band);
/// Draws depth and name.
void draw_deferred(const TriangleChunk& chunk, uint32_t first_name, std::span<const uint32_t> list, RasterBand& band);

/// Calls visit for each block in which a triangle is nearer than what is seen: bits of its pixels, and depths.
using VisitBlock = FunctionRef<void(int x, int y, uint32_t bits, const float* depth)>;
void visit_nearer(const TriangleRecord& record, const VisibilityBuffer& visible, VisitBlock visit);

/// Positions, channels and surface coordinates of a batch, from the planes of its records.
void interpolate(const RasterFrame& frame, const Pipeline& pipeline, ShadeBatch& batch);
/// Evaluates the textures of a batch; bends normals by normal maps.
void apply_textures(const RasterFrame& frame, const Pipeline& pipeline, bool layers, ShadeBatch& batch);
/// Whether a masked material is there at a pixel of a triangle.
bool passes_mask(const RasterFrame& frame, uint32_t name, int x, int y, float depth);

/// What is seen beyond everything: the same everywhere, or pixel by pixel.
struct Background {
  Rgb uniform;
  bool varies;
  bool fill;  // wanted in the band's colours, not only where bands become pictures
  FunctionRef<Rgb(int x, int y)> at;
};

/// A band of the frame: cleared,
void clear_band(const RasterFrame& frame, int index, RasterBand& band);
/// its opaque surfaces of the pass in hand drawn and shaded: what earlier passes have shaded keeps depth and colour,
void draw_opaque(const RasterFrame& frame, int index, RasterBand& band);
/// and finished: the background of pixels that see none where it varies, is wanted, or has blended surfaces before it,
/// and those from back to front.
void finish_band(const RasterFrame& frame, int index, const Background& background, RasterBand& band);
void shade_opaque(const RasterFrame& frame, RasterBand& band);
/// Lights the pixels of pipelines on spans: colour is written where they are plain, and nobody into `seen`; else what
/// is lit waits in band.on_spans for its textures.
void shade_spans(const RasterFrame& frame, int index, RasterBand& band);
/// The same for one triangle, where `seen` names it.
void shade_spans_of(const RasterFrame& frame, uint32_t name, uint32_t* seen, RasterBand& band);
void fill_background(const RasterFrame& frame, const Background& background, RasterBand& band);
void draw_blended(const RasterFrame& frame, int index, RasterBand& band);

}  // namespace aktina
