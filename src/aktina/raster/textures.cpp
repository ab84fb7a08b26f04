// What textures, vertex colours and normal maps say at visible pixels.
#include <algorithm>

#include "aktina/raster/band.h"

namespace aktina {
namespace {

/// A pixel's place on its triangle.
struct Place {
  const DrawPart* part;
  uint32_t vertex[3];  // of the draw list
  float weight[3];
};

Place place_of(const RasterFrame& frame, uint32_t triangle, float b1, float b2) {
  const auto parts = frame.list.parts();
  const auto after = std::upper_bound(parts.begin(), parts.end(), triangle,
                                      [](uint32_t t, const DrawPart& p) { return t < p.first_triangle; });
  Place place{&*(after - 1), {}, {1 - b1 - b2, b1, b2}};
  for (int k = 0; k < 3; ++k) place.vertex[k] = frame.list.index(k)[triangle];
  return place;
}

template <class T>
T between(const std::vector<T>& values, const Place& p, T none) {
  if (values.empty()) return none;
  T sum(0);
  for (int k = 0; k < 3; ++k) sum += p.weight[k] * values[p.part->mesh_vertex(p.vertex[k])];
  return sum;
}

Vec3 normal_at(const RasterFrame& frame, const Place& p) {
  Vec3 n(0);
  for (int k = 0; k < 3; ++k) n += p.weight[k] * frame.list.normal_of(p.vertex[k]);
  return n;
}

/// Along which u grows: the mesh's tangents, or the triangle's own. w: handedness.
Vec4 tangent_at(const RasterFrame& frame, const Place& p, int uv_set) {
  const Mesh& mesh = *p.part->mesh;
  if (!mesh.tangents.empty() && !p.part->flat) return between(mesh.tangents, p, Vec4(0));
  const auto& uv = mesh.uv[uv_set];
  if (uv.empty()) return Vec4(0);
  Vec2 t[3];
  for (int k = 0; k < 3; ++k) t[k] = uv[p.part->mesh_vertex(p.vertex[k])];
  const Point3 a = frame.list.position_of(p.vertex[0]);
  const Vec3 e1 = frame.list.position_of(p.vertex[1]) - a, e2 = frame.list.position_of(p.vertex[2]) - a;
  const Vec2 d1 = t[1] - t[0], d2 = t[2] - t[0];
  const float determinant = d1.x * d2.y - d2.x * d1.y;
  if (determinant == 0) return Vec4(0);
  return Vec4((e1 * d2.y - e2 * d1.y) / determinant, determinant < 0 ? 1.0f : -1.0f);  // v runs down
}

/// The front's normal n, unit, bent by a normal map.
Vec3 bent(const RasterFrame& frame, const Material& m, const Place& p, const Vec2 (&uv)[2], Vec3 n) {
  const Vec4 along = tangent_at(frame, p, m.normal_texture.uv_set);
  const Vec3 t = normalize_or(Vec3(along) - n * dot(n, Vec3(along)), Vec3(0));
  if (t == Vec3(0)) return n;
  const Vec4 texel =
      look_up(frame.scene.images[size_t(m.normal_texture.image)], m.normal_texture, uv[m.normal_texture.uv_set], false);
  const Vec3 local((2 * texel.x - 1) * m.normal_scale, (2 * texel.y - 1) * m.normal_scale, 2 * texel.z - 1);
  const Vec3 b = cross(n, t) * (along.w < 0 ? -1.0f : 1.0f);
  return normalize_or(t * local.x + b * local.y + n * local.z, n);
}

void put(float (&to)[3][ShadeBatch::kPixels], size_t i, Vec3 v) {
  for (int k = 0; k < 3; ++k) to[k][i] = v[k];
}
void put(float (&to)[3][ShadeBatch::kPixels], size_t i, Rgb v) {
  for (int k = 0; k < 3; ++k) to[k][i] = v[k];
}

void apply(const RasterFrame& frame, const Pipeline& pipeline, bool layers, ShadeBatch& b, size_t i) {
  const RecordSource& source = frame.source(b.seen[i]);
  const Material& m = *pipeline.material;
  const Place p = place_of(frame, source.triangle, b.surface[0][i], b.surface[1][i]);
  const Mesh& mesh = *p.part->mesh;
  const Vec2 uv[2] = {between(mesh.uv[0], p, Vec2(0)), between(mesh.uv[1], p, Vec2(0))};
  const MaterialPoint point = evaluate(frame.scene, m, uv, between(mesh.colours, p, Vec4(1)));
  const Surface surface = without_rays(point.surface);
  put(b.ka, i, surface.ka), put(b.kd, i, surface.kd), put(b.ks, i, surface.ks);
  b.exponent[i] = surface.exponent;
  if (pipeline.light.reads_whole_surface()) b.whole[i] = surface;
  b.alpha[i] = point.alpha;
  put(b.emission, i, pipeline.emits_on(source.front) ? point.emission.v : Rgb());
  const float side = source.front ? 1.0f : -1.0f;
  const bool bends = bool(m.normal_texture) && pipeline.plan.normal;
  if (bends) {
    const Vec3 n = normalize_or(side * Vec3(b.channel[0][i], b.channel[1][i], b.channel[2][i]), {0, 0, 1});
    const Vec3 changed = side * bent(frame, m, p, uv, n);
    for (int k = 0; k < 3; ++k) b.channel[k][i] = changed[k];
  }
  if (!layers) return;
  put(b.albedo, i, m.unlit ? point.emission.v : point.surface.base);
  put(b.normal, i,
      bends ? Vec3(b.channel[0][i], b.channel[1][i], b.channel[2][i])
            : side * normalize_or(normal_at(frame, p), {0, 0, 1}));
}

}  // namespace

void apply_textures(const RasterFrame& frame, const Pipeline& pipeline, bool layers, ShadeBatch& b) {
  if (pipeline.light.reads_whole_surface()) b.whole.resize(ShadeBatch::kPixels);
  for (size_t i = 0; i < b.blocks * kLanes; ++i) {
    if (b.seen[i] != kNobody) {
      apply(frame, pipeline, layers, b, i);
      continue;
    }
    put(b.ka, i, Rgb()), put(b.kd, i, Rgb()), put(b.ks, i, Rgb()), put(b.emission, i, Rgb());
    b.exponent[i] = 1, b.alpha[i] = 0;
  }
}

bool passes_mask(const RasterFrame& frame, uint32_t name, int x, int y, float depth) {
  const TriangleRecord& r = frame.record(name);
  const RecordSource& source = frame.source(name);
  const float* planes = frame.planes(name);
  const float dx = float(x - r.origin_x()), dy = float(y - r.origin_y());
  const float w = frame.view.perspective() ? 1 / depth : 1;
  const auto at = [&](const float* plane) { return (plane[0] + plane[1] * dx + plane[2] * dy) * w; };
  const Place p = place_of(frame, source.triangle, at(planes), at(planes + 3));
  const Material& m = *frame.pipelines.all[source.pipeline].material;
  float alpha = m.alpha * between(p.part->mesh->colours, p, Vec4(1)).w;
  if (m.base_texture)
    alpha *= look_up(frame.scene.images[size_t(m.base_texture.image)], m.base_texture,
                     between(p.part->mesh->uv[m.base_texture.uv_set], p, Vec2(0)), true)
                 .w;
  return alpha >= m.alpha_cutoff;
}

}  // namespace aktina
