#include <algorithm>

#include "aktina/raster/raster_frame.h"

namespace aktina {
namespace {

constexpr size_t kPiece = 256;  // vertices at a time

/// What unlit materials show: base colour times vertex colour.
void copy_colours(const DrawPart& part, const Pipeline& pipeline, uint32_t begin, uint32_t end, VertexRadiance& out) {
  for (uint32_t v = begin; v < end; ++v) {
    Rgb c = pipeline.material->base_colour;
    if (pipeline.coloured) {
      const Vec4 colour = part.mesh->colours[part.mesh_vertex(v)];
      c *= Rgb(colour.x, colour.y, colour.z);
    }
    for (int k = 0; k < 3; ++k) out.front[k][v] = out.back[k][v] = c[k];
  }
}

void light_side(const DrawList& list, const Pipeline& pipeline, uint32_t begin, uint32_t end, float side,
                LineArray<float> (&out)[6]) {
  alignas(64) float normal[3][kPiece], specular[3][kPiece];
  for (uint32_t first = begin; first < end; first += kPiece) {
    const size_t count = std::min<size_t>(kPiece, end - first);
    for (int k = 0; k < 3; ++k)
      for (size_t i = 0; i < padded(count); ++i) normal[k][i] = side * list.normal(k)[first + i];
    const bool apart = pipeline.radiance_channels() == 6;
    float* d[3];
    float* s[3];
    for (int k = 0; k < 3; ++k) d[k] = out[k].data() + first, s[k] = apart ? out[3 + k].data() + first : specular[k];
    pipeline.light.evaluate({count,
                             {list.position(0) + first, list.position(1) + first, list.position(2) + first},
                             {normal[0], normal[1], normal[2]}},
                            {{d[0], d[1], d[2]}, {s[0], s[1], s[2]}});
    for (int k = 0; k < 3 && !apart; ++k)
      for (size_t i = 0; i < count; ++i) d[k][i] += s[k][i];
  }
}

}  // namespace

void light_vertices(const DrawList& list, const DrawPart& part, const Pipeline& pipeline, uint32_t begin, uint32_t end,
                    VertexRadiance& out) {
  if (!(pipeline.plan.needs & ShadingPlan::kRadiance)) return;
  if (pipeline.layout.channels == 0 && !pipeline.spans()) return;
  if (!pipeline.lit) return copy_colours(part, pipeline, begin, end, out);
  light_side(list, pipeline, begin, end, 1, out.front);
  if (!pipeline.cull) light_side(list, pipeline, begin, end, -1, out.back);
}

}  // namespace aktina
