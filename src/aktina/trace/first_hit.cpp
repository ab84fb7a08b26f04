#include "aktina/trace/first_hit.h"

#include "aktina/base/parallel.h"
#include "aktina/trace/offset.h"

namespace aktina {
namespace {

constexpr int kMostLayers = 256;

struct Features {
  Image* albedo = nullptr;
  Image* normal = nullptr;
  Image* position = nullptr;
  Image* depth = nullptr;
};

void set(Image* image, int x, int y, Vec3 v) {
  if (image) image->set_rgb(x, y, {v.x, v.y, v.z});
}

void fill_row(const RayScene& scene, const CameraRays& camera, const Features& out, int width, int y) {
  for (int x = 0; x < width; ++x) {
    ShadingPoint point;
    const bool hit = first_solid_hit(scene, camera.at(float(x) + 0.5f, float(y) + 0.5f), point);
    if (out.depth) *out.depth->at(x, y) = hit ? camera.depth(point.position) : kInfinity;
    if (!hit) continue;
    if (out.albedo) out.albedo->set_rgb(x, y, point.surface->base);
    set(out.normal, x, y, point.normal);
    set(out.position, x, y, point.position);
  }
}

}  // namespace

bool first_solid_hit(const RayScene& scene, Ray ray, ShadingPoint& out) {
  for (int layer = 0; layer < kMostLayers; ++layer) {
    const Hit hit = scene.accelerator->intersect(ray);
    if (!hit) return false;
    scene.surfaces.shade(ray, hit, false, out);
    if (out.alpha >= 0.5f) return true;
    ray = {offset_point(out.position, -out.geometric), ray.direction};
  }
  return false;
}

void add_first_hit_layers(const RayScene& scene, const CameraRays& camera, const TraceOptions& options,
                          LayeredImage& picture) {
  const int width = picture.layers[0].image.width, height = picture.layers[0].image.height;
  Features out;
  picture.layers.reserve(picture.layers.size() + 4);  // pointers into it stay good
  if (options.albedo) out.albedo = &picture.add("albedo", width, height, 3);
  if (options.normal) out.normal = &picture.add("N", width, height, 3);
  if (options.position) out.position = &picture.add("P", width, height, 3);
  if (options.depth) out.depth = &picture.add("Z", width, height, 1);
  if (!out.albedo && !out.normal && !out.position && !out.depth) return;
  parallel_for(size_t(height), 4, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) fill_row(scene, camera, out, width, int(y));
  });
}

}  // namespace aktina
