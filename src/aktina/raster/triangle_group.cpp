#include "aktina/raster/triangle_group.h"

namespace aktina {
namespace {

/// value(lane, vertex) at corner k of each triangle: a vertex's own, or between the three of a clipped one.
template <class Value>
void at_corners(const CornerGroup& c, const Value& value, Lanes* const (&out)[3]) {
  for (int k = 0; k < 3; ++k) {
    Lanes& to = *out[k];
    if (!c.clipped) {
      for (size_t i = 0; i < kLanes; ++i) to[i] = value(i, c.vertex[k][i]);
      continue;
    }
    for (size_t i = 0; i < kLanes; ++i) {
      to[i] = 0;
      for (int j = 0; j < 3; ++j) to[i] += c.barycentric[k][j][i] * value(i, c.vertex[j][i]);
    }
  }
}

void fill_positions(const DrawList& list, const CornerGroup& c, TriangleGroup& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const float* from = list.position(axis);
    at_corners(c, [&](size_t, uint32_t v) { return from[v]; },
               {&out.position[0][axis], &out.position[1][axis], &out.position[2][axis]});
  }
}

void fill_normals(const DrawList& list, const CornerGroup& c, TriangleGroup& out) {
  for (int axis = 0; axis < 3; ++axis) {
    const float* from = list.normal(axis);
    at_corners(c, [&](size_t i, uint32_t v) { return c.side[i] * from[v]; },
               {&out.normal[0][axis], &out.normal[1][axis], &out.normal[2][axis]});
  }
  if (!c.clipped) return;
  for (auto& corner : out.normal)
    for (size_t i = 0; i < kLanes; ++i) {
      const Vec3 n = normalize_or({corner[0][i], corner[1][i], corner[2][i]}, {0, 0, 1});
      for (int axis = 0; axis < 3; ++axis) corner[axis][i] = n[axis];
    }
}

void fill_face_normals(const DrawList& list, const CornerGroup& c, TriangleGroup& out) {
  for (size_t i = 0; i < kLanes; ++i) {
    Point3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = list.position_of(list.index(k)[c.triangle[i]]);
    const Vec3 n = c.side[i] * normalize_or(cross(p[1] - p[0], p[2] - p[0]), {0, 0, 1});
    for (int axis = 0; axis < 3; ++axis) out.face_normal[axis][i] = n[axis];
  }
}

void fill_radiance(const VertexRadiance& radiance, const CornerGroup& c, TriangleGroup& out) {
  for (int first = 0; first < out.channels; first += 3) {
    const float* rows = (first == 0 ? radiance.light : radiance.specular).data();
    if (!c.clipped) {
      take_radiance(rows, c, first, out.radiance);
      continue;
    }
    for (int k = 0; k < 3; ++k)
      at_corners(c, [&](size_t i, uint32_t v) { return rows[VertexRadiance::row(v, c.side[i] > 0) + size_t(k)]; },
                 {&out.radiance[0][first + k], &out.radiance[1][first + k], &out.radiance[2][first + k]});
  }
}

/// A polynomial above degree 1 bends between its corners: there a cut corner is lit itself, not interpolated.
void light_corners(const Illuminator& light, TriangleGroup& out) {
  for (int k = 0; k < 3; ++k) {
    Lanes lit[6];
    light.evaluate({kLanes,
                    {out.position[k][0].v, out.position[k][1].v, out.position[k][2].v},
                    {out.normal[k][0].v, out.normal[k][1].v, out.normal[k][2].v}},
                   {{lit[0].v, lit[1].v, lit[2].v}, {lit[3].v, lit[4].v, lit[5].v}});
    for (int channel = 0; channel < out.channels; ++channel)
      for (size_t i = 0; i < kLanes; ++i)
        out.radiance[k][channel][i] = lit[channel][i] + (out.channels == 3 ? lit[channel + 3][i] : 0);
  }
}

void fill_screen(const View& view, const CornerGroup& c, TriangleGroup& out) {
  for (int k = 0; k < 3; ++k)
    for (size_t i = 0; i < kLanes; ++i) {
      out.screen[k][0][i] = float(c.x[k][i]) / kSubpixels, out.screen[k][1][i] = float(c.y[k][i]) / kSubpixels;
      out.weight[k][i] = view.perspective() ? c.depth[k][i] : 1;
    }
}

}  // namespace

void fill_group(const RasterFrame& frame, const Pipeline& pipeline, const CornerGroup& c, TriangleGroup& out) {
  const unsigned needs = pipeline.plan.needs;
  const bool bent = c.clipped && pipeline.lit && pipeline.plan.degree >= 2 && (needs & ShadingPlan::kRadiance);
  out.count = c.count;
  out.channels = pipeline.radiance_channels();
  if (bent || (needs & ShadingPlan::kPosition)) fill_positions(frame.list, c, out);
  if (bent || (needs & ShadingPlan::kNormal)) fill_normals(frame.list, c, out);
  if (needs & ShadingPlan::kFaceNormal) fill_face_normals(frame.list, c, out);
  if (needs & ShadingPlan::kScreen) fill_screen(frame.view, c, out);
  if (bent) {
    light_corners(pipeline.light, out);
  } else if (needs & ShadingPlan::kRadiance) {
    fill_radiance(frame.radiance, c, out);
  }
}

}  // namespace aktina
