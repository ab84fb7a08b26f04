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
    for (const bool front : {true, false})
      for (int k = 0; k < 3; ++k) out.light[VertexRadiance::row(v, front) + size_t(k)] = c[k];
  }
}

void light_side(const DrawList& list, const Pipeline& pipeline, uint32_t begin, uint32_t end, bool front,
                VertexRadiance& out) {
  alignas(64) float normal[3][kPiece], diffuse[3][kPiece], specular[3][kPiece];
  const float side = front ? 1.0f : -1.0f;
  for (uint32_t first = begin; first < end; first += kPiece) {
    const size_t count = std::min<size_t>(kPiece, end - first);
    for (int k = 0; k < 3; ++k)
      for (size_t i = 0; i < padded(count); ++i) normal[k][i] = side * list.normal(k)[first + i];
    pipeline.light.evaluate({count,
                             {list.position(0) + first, list.position(1) + first, list.position(2) + first},
                             {normal[0], normal[1], normal[2]}},
                            {{diffuse[0], diffuse[1], diffuse[2]}, {specular[0], specular[1], specular[2]}});
    if (pipeline.radiance_channels() == 6) {
      put_radiance({specular[0], specular[1], specular[2]}, count, first, front, out.specular.data());
    } else {
      for (int k = 0; k < 3; ++k)
        for (size_t i = 0; i < padded(count); ++i) diffuse[k][i] += specular[k][i];
    }
    put_radiance({diffuse[0], diffuse[1], diffuse[2]}, count, first, front, out.light.data());
  }
}

}  // namespace

void light_vertices(const DrawList& list, const DrawPart& part, const Pipeline& pipeline, uint32_t begin, uint32_t end,
                    VertexRadiance& out) {
  if (!(pipeline.plan.needs & ShadingPlan::kRadiance)) return;
  if (pipeline.layout.channels == 0 && !pipeline.spans()) return;
  if (!pipeline.lit) return copy_colours(part, pipeline, begin, end, out);
  light_side(list, pipeline, begin, end, true, out);
  if (!pipeline.cull) light_side(list, pipeline, begin, end, false, out);
}

}  // namespace aktina
