// One picture in the making: what its steps share.
//
// vertices to the screen -> triangles gathered, set up and sorted into bands of rows, chunk by chunk -> bands drawn and
// resolved. Chunks and bands are cut without regard to threads, and each band takes the chunks in their order: the same
// bytes for any number of threads. Of large scenes a part of the chunks is in memory at a time (passes.h).
#pragma once

#include "aktina/raster/pipeline.h"
#include "aktina/raster/vertex_stage.h"

namespace aktina {

inline constexpr uint32_t kChunkTriangles = 2048;
inline constexpr int kChunkBits = 14;  // records of a chunk: clipping makes up to seven of a triangle
inline constexpr int kBandRows = 32;

/// The triangle that a record came from.
struct RecordSource {
  uint32_t triangle;
  uint16_t pipeline;
  bool front;
  uint8_t lane;    // of methods on spans: its place in
  uint32_t group;  // TriangleChunk::groups
};

/// Triangles that were set up together, and in which bands they are.
struct TriangleChunk {
  struct Run {
    uint32_t first;  // record
    uint32_t pipeline;
  };
  struct Blended {
    uint32_t record;
    float depth;  // mean of the corners
  };
  uint32_t count = 0;
  std::vector<TriangleRecord> records;
  std::vector<RecordSource> sources;  // says nothing of immediate pipelines
  LineArray<float> planes;
  uint32_t group_count = 0;
  std::vector<TriangleGroup> groups;  // of pipelines on spans
  std::vector<Run> runs;
  std::vector<std::vector<uint32_t>> bands;   // records, ascending
  std::vector<std::vector<Blended>> blended;  // by band
};

/// Radiance at vertices: the illumination model with the vertex normal, or its opposite for backs. A row of four
/// numbers for each side of each vertex: front, back, front, ...; three channels and a number that says nothing.
struct VertexRadiance {
  LineArray<float> light;     // all together; of textured pipelines, what is diffuse
  LineArray<float> specular;  // of textured pipelines
  static size_t row(size_t vertex, bool front) { return 8 * vertex + (front ? 0 : 4); }
};

/// Writes rows of one side of the vertices first, first + 1 ... @param count  of channels' values, padded
void put_radiance(const float* const (&channels)[3], size_t count, size_t first, bool front, float* rows);
/// Reads the rows of the corners of a group that is not clipped into out[corner][first_channel ...].
void take_radiance(const float* rows, const CornerGroup& corners, int first_channel, Lanes (&out)[3][6]);

struct RasterFrame {
  const Scene& scene;
  const DrawList& list;
  const View& view;
  const Pipelines& pipelines;
  const ScreenVertices& screen;
  const VertexRadiance& radiance;
  std::vector<TriangleChunk>& chunks;  // of the pass in hand
  uint32_t first_chunk = 0;            // of the pass, among all of the scene

  int bands() const { return (view.height() + kBandRows - 1) / kBandRows; }
  size_t stride() const { return pipelines.lines * kLanes; }
  /// A record's name: its chunk in the pass and its place there.
  const TriangleChunk& chunk_of(uint32_t name) const { return chunks[name >> kChunkBits]; }
  static uint32_t place(uint32_t name) { return name & ((1U << kChunkBits) - 1); }
  const TriangleRecord& record(uint32_t name) const { return chunk_of(name).records[place(name)]; }
  const RecordSource& source(uint32_t name) const { return chunk_of(name).sources[place(name)]; }
  const float* planes(uint32_t name) const { return chunk_of(name).planes.data() + place(name) * stride(); }
};

/// Fills the radiance of vertices begin .. end - 1 of a part (begin a multiple of kLanes).
void light_vertices(const DrawList& list, const DrawPart& part, const Pipeline& pipeline, uint32_t begin, uint32_t end,
                    VertexRadiance& out);

/// Sets up the triangles of chunk `index` of the pass.
void build_chunk(const RasterFrame& frame, uint32_t index);

}  // namespace aktina
