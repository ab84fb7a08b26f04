// Rules of thumb for memory and time; docs/info.md states them.
#include <algorithm>
#include <cmath>

#include "aktina/base/parallel.h"
#include "aktina/render/info.h"

namespace aktina {
namespace {

constexpr double kPixels = 960 * 640, kBytesPerPixel = 64, kEmbreeBytesPerTriangle = 150;
constexpr double kRasterBytesPerTriangle = 200, kPassBytes = 13e6, kPassBytesPerPixel = 80;  // raster/passes.h
constexpr double kIndirectRays = 3e6, kRaysPerPatch = 60;
constexpr double kUsualPatches = 12'000;  // where the patch size is left to Aktina

double scene_bytes(const Scene& scene) {
  double bytes = 0;
  for (const Mesh& m : scene.meshes)
    bytes += double(12 * (m.positions.size() + m.normals.size() + m.triangles.size()) + 16 * m.tangents.size() +
                    8 * (m.uv[0].size() + m.uv[1].size()) + 16 * m.colours.size() + 4 * m.triangle_face.size());
  for (const TextureImage& image : scene.images) {
    const auto* bitmap = std::get_if<Bitmap>(&image.pixels);
    bytes += double(image.encoded.size()) + (bitmap ? 1.0 : 4.0) * 4.0 * image.width() * image.height();
  }
  return bytes + 4.0 * double(scene.environment.radiance.pixels.size());
}

}  // namespace

std::vector<JobEstimate> estimate_jobs(const Scene& scene) {
  const double n = double(triangle_count(scene)), own = scene_bytes(scene), threads = std::max(1, thread_count());
  const double accelerator = kEmbreeBytesPerTriangle * n, picture = kBytesPerPixel * kPixels;
  const double set_up = std::min(kRasterBytesPerTriangle * n, kPassBytes + kPassBytesPerPixel * kPixels);
  const double depth = std::log2(n + 2);
  const double patches = std::max(n, kUsualPatches);
  const double ray = 1e-7 * depth;  // s
  return {
      {"render raster", own + set_up + picture, (1e-7 * n + 4 * kPixels * 1e-7) / threads},
      {"render path", own + accelerator + picture, (64 * 2.5 * kPixels * ray + 5e-7 * n) / threads},
      {"radiosity", own + accelerator + 200 * patches,
       ((kIndirectRays + kRaysPerPatch * patches) * ray + 5e-7 * n) / threads},
  };
}

}  // namespace aktina
