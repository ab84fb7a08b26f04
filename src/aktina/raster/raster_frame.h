// One picture in the making: what its steps share.
//
// vertices to the screen -> triangles gathered, set up and sorted into bands of rows, chunk by chunk -> bands drawn and
// resolved. Chunks and bands are cut without regard to threads, and each band takes the chunks in their order: the same
// bytes for any number of threads.
#pragma once

#include "aktina/raster/pipeline.h"
#include "aktina/raster/vertex_stage.h"

namespace aktina {

inline constexpr uint32_t kChunkTriangles = 2048;
inline constexpr int kChunkBits = 14;  // records of a chunk: clipping makes up to seven of a triangle
inline constexpr int kBandRows = 64;

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
  std::vector<RecordSource> sources;
  LineArray<float> planes;
  uint32_t group_count = 0;
  std::vector<TriangleGroup> groups;  // of pipelines on spans
  std::vector<Run> runs;
  std::vector<std::vector<uint32_t>> bands;   // records, ascending
  std::vector<std::vector<Blended>> blended;  // by band
};

/// Radiance at vertices: the illumination model with the vertex normal, or its opposite for backs.
struct VertexRadiance {
  LineArray<float> front[6], back[6];  // channels as TriangleGroup::radiance
};

struct RasterFrame {
  const Scene& scene;
  const DrawList& list;
  const View& view;
  const Pipelines& pipelines;
  const ScreenVertices& screen;
  const VertexRadiance& radiance;
  std::vector<TriangleChunk>& chunks;

  int bands() const { return (view.height() + kBandRows - 1) / kBandRows; }
  size_t stride() const { return pipelines.lines * kLanes; }
  /// A record's name: its chunk and its place there.
  const TriangleChunk& chunk_of(uint32_t name) const { return chunks[name >> kChunkBits]; }
  static uint32_t place(uint32_t name) { return name & ((1U << kChunkBits) - 1); }
  const TriangleRecord& record(uint32_t name) const { return chunk_of(name).records[place(name)]; }
  const RecordSource& source(uint32_t name) const { return chunk_of(name).sources[place(name)]; }
  const float* planes(uint32_t name) const { return chunk_of(name).planes.data() + place(name) * stride(); }
};

/// Fills the radiance of vertices begin .. end - 1 of a part (begin a multiple of kLanes).
void light_vertices(const DrawList& list, const DrawPart& part, const Pipeline& pipeline, uint32_t begin, uint32_t end,
                    VertexRadiance& out);

/// Sets up the triangles of chunk `index`.
void build_chunk(const RasterFrame& frame, uint32_t index);

}  // namespace aktina
