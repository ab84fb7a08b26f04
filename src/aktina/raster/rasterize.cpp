#include "aktina/raster/rasterize.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "aktina/raster/clip.h"
#include "aktina/scene/scene_lights.h"
#include "aktina/raster/shading/shading_method.h"

namespace aktina {
namespace {

struct Pixel {
  float depth;
  Rgb colour, albedo;
  Vec3 normal, position;
  uint32_t item = ItemBuffer::kNothing;
};

struct RasterFrame {
  const Scene& scene;
  View view;
  std::unique_ptr<ShadingMethod> method;
  IlluminationModel model;
  SceneLights lights;
  bool cull;
  std::vector<Pixel> pixels;
};

struct Corner {
  Vec3 position, normal;
  Vec2 uv[2];
  Vec4 colour;
};

void draw(RasterFrame& f, const Mesh& mesh, const Instance& instance, const Material& material, uint32_t first_item) {
  const Mat4 to_clip = f.view.clip_from_world() * instance.to_world;
  const Mat3 normal_matrix = glm::transpose(glm::inverse(Mat3(instance.to_world)));
  const bool mirrored = glm::determinant(Mat3(instance.to_world)) < 0;
  const Clipper clipper(f.view);
  const Illuminator white(
      f.model,
      [&] {
        Surface s = surface_of(material);
        return s;
      }(),
      f.lights.lights, f.lights.ambient, f.view.viewer());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& ix = mesh.triangles[t];
    std::array<Vec4, 3> clip;
    Corner corner[3];
    for (size_t v = 0; v < 3; ++v) {
      corner[v].position = transform_point(instance.to_world, mesh.positions[ix[v]]);
      clip[v] = to_clip * Vec4(mesh.positions[ix[v]], 1);
    }
    const Vec3 face = normalize_or(
        cross(corner[1].position - corner[0].position, corner[2].position - corner[0].position), {0, 0, 1});
    for (size_t v = 0; v < 3; ++v) {
      corner[v].normal = mesh.normals.empty() ? face : normalize_or(normal_matrix * mesh.normals[ix[v]], face);
      for (int s = 0; s < 2; ++s) corner[v].uv[s] = mesh.uv[s].empty() ? Vec2(0) : mesh.uv[s][ix[v]];
      corner[v].colour = mesh.colours.empty() ? Vec4(1) : mesh.colours[ix[v]];
    }
    if (clipper.outside(clip[0]) & clipper.outside(clip[1]) & clipper.outside(clip[2])) continue;
    std::array<ClipVertex, kMostClippedVertices> polygon;
    const int n = clipper.clip(clip, polygon);
    for (int k = 2; k < n; ++k) {
      const ClipVertex* cv[3] = {&polygon[0], &polygon[size_t(k - 1)], &polygon[size_t(k)]};
      ScreenVertex s[3];
      for (int v = 0; v < 3; ++v) s[v] = f.view.project(cv[v]->clip);
      const int64_t area = int64_t(s[1].x - s[0].x) * (s[2].y - s[0].y) - int64_t(s[2].x - s[0].x) * (s[1].y - s[0].y);
      if (area == 0) continue;
      const bool front = (area < 0) != mirrored;  // y runs down
      if (!front && f.cull && !material.double_sided) continue;
      const float side = front ? 1.0f : -1.0f;
      TriangleGroup g{};
      g.count = 1, g.channels = 6;
      for (int v = 0; v < 3; ++v) {
        const Vec3 b = cv[v]->barycentric;
        const Vec3 p = b.x * corner[0].position + b.y * corner[1].position + b.z * corner[2].position;
        const Vec3 nv = normalize_or(side * (b.x * corner[0].normal + b.y * corner[1].normal + b.z * corner[2].normal),
                                     side * face);
        for (int a = 0; a < 3; ++a)
          g.position[v][a][0] = p[a], g.normal[v][a][0] = nv[a], g.face_normal[a][0] = side * face[a];
        g.weight[v][0] = s[v].weight;
        g.screen[v][0][0] = float(s[v].x) / kSubpixels, g.screen[v][1][0] = float(s[v].y) / kSubpixels;
        const Lit lit =
            illuminate(f.model, white.surface(), f.lights.lights, f.lights.ambient, p, nv, f.view.viewer().towards(p));
        for (int a = 0; a < 3; ++a) g.radiance[v][a][0] = lit.diffuse[a], g.radiance[v][3 + a][0] = lit.specular[a];
      }
      const ShadingPlan plan = f.method->plan(white);
      Lanes values[kMostLatticePoints * 8];
      const int channels = plan.kind == ShadingPlan::Kind::colour ? 6 : plan.channels;
      Samples samples(values, channels);
      f.method->prepare(g, white, samples);
      const int points = int(lattice(plan.degree).size());
      int x0 = std::min({s[0].x, s[1].x, s[2].x}), x1 = std::max({s[0].x, s[1].x, s[2].x});
      int y0 = std::min({s[0].y, s[1].y, s[2].y}), y1 = std::max({s[0].y, s[1].y, s[2].y});
      x0 = std::max(x0 >> 8, 0), y0 = std::max(y0 >> 8, 0);
      x1 = std::min(x1 >> 8, f.view.width() - 1), y1 = std::min(y1 >> 8, f.view.height() - 1);
      const int64_t sign = area > 0 ? 1 : -1;
      for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
          double l[3];
          bool inside = true;
          for (int e = 0; e < 3 && inside; ++e) {
            const ScreenVertex &a = s[(e + 1) % 3], &b = s[(e + 2) % 3];
            const int64_t ax = sign * int64_t(a.y - b.y), ay = sign * int64_t(b.x - a.x);
            const int64_t value = ax * (x * 256 + 128 - a.x) + ay * (y * 256 + 128 - a.y);
            inside = value > 0 || (value == 0 && (ax > 0 || (ax == 0 && ay > 0)));
            l[e] = double(value) / double(sign * area);
          }
          if (!inside) continue;
          float depth = 0, w = 0, pb[3], sb[3];
          for (int v = 0; v < 3; ++v) depth += float(l[v]) * s[v].depth, w += float(l[v]) * s[v].weight;
          Pixel& pixel = f.pixels[size_t(y) * size_t(f.view.width()) + size_t(x)];
          if (!(depth > pixel.depth)) continue;
          for (int v = 0; v < 3; ++v) sb[v] = float(l[v]), pb[v] = sb[v] * s[v].weight / w;
          const float* bary = plan.perspective ? pb : sb;
          alignas(64) float channel[8][kLanes];
          for (int c = 0; c < channels; ++c) {
            channel[c][0] = points == 1 ? samples(0, c)[0] : 0;
            for (int v = 0; v < 3 && points == 3; ++v) channel[c][0] += bary[v] * samples(v, c)[0];
          }
          Vec3 original(0);
          for (int v = 0; v < 3; ++v) original += pb[v] * cv[v]->barycentric;
          Vec2 uv[2] = {Vec2(0), Vec2(0)};
          Vec4 colour(0);
          Vec3 normal(0);
          for (int v = 0; v < 3; ++v) {
            for (int q = 0; q < 2; ++q) uv[q] += original[v] * corner[v].uv[q];
            colour += original[v] * corner[v].colour, normal += original[v] * corner[v].normal;
          }
          const MaterialPoint point = evaluate(f.scene, material, uv, colour);
          if (material.alpha_mode != AlphaMode::opaque && point.alpha < 0.5f) continue;
          const Point3 p = f.view.point(float(x) + 0.5f, float(y) + 0.5f, depth);
          Rgb diffuse, specular;
          if (plan.kind == ShadingPlan::Kind::attributes) {
            alignas(64) float position[3][kLanes], d[3][kLanes], sp[3][kLanes];
            for (int a = 0; a < 3; ++a) position[a][0] = p[a];
            alignas(64) float ka[3][kLanes], kd[3][kLanes], ks[3][kLanes], exponent[kLanes];
            for (int a = 0; a < 3; ++a)
              ka[a][0] = point.surface.ka[a], kd[a][0] = point.surface.kd[a], ks[a][0] = point.surface.ks[a];
            exponent[0] = point.surface.exponent;
            const SurfaceArrays arrays{{ka[0], ka[1], ka[2]}, {kd[0], kd[1], kd[2]}, {ks[0], ks[1], ks[2]}, exponent};
            const float* pointers[8];
            for (int c = 0; c < 8; ++c) pointers[c] = channel[c];
            f.method->shade({1, pointers, {position[0], position[1], position[2]}, &arrays}, white,
                            {{d[0], d[1], d[2]}, {sp[0], sp[1], sp[2]}});
            diffuse = {d[0][0], d[1][0], d[2][0]}, specular = {sp[0][0], sp[1][0], sp[2][0]};
          } else {
            diffuse = {channel[0][0], channel[1][0], channel[2][0]},
            specular = {channel[3][0], channel[4][0], channel[5][0]};
            for (int a = 0; a < 3; ++a)
              diffuse[a] *= white.surface().kd[a] > 0 ? point.surface.kd[a] / white.surface().kd[a] : 1;
            if (material.unlit) diffuse = specular = Rgb(0);
          }
          pixel.depth = depth;
          pixel.colour = diffuse + specular;
          if (front || material.double_sided || material.unlit) pixel.colour += point.emission.v;
          pixel.albedo = point.surface.base;
          pixel.normal = normalize_or(side * normal, side * face);
          pixel.position = p;
          pixel.item = first_item + t;
        }
    }
  }
}

void draw_all(RasterFrame& f) {
  uint32_t item = 0;
  const float tolerance = 1e-3f * bounds(f.scene).diagonal();
  for (const Instance& instance : f.scene.instances) {
    const Material& material = f.scene.material_of(instance);
    if (instance.mesh >= 0) {
      const Mesh& mesh = f.scene.meshes[size_t(instance.mesh)];
      draw(f, mesh, instance, material, item);
      item += uint32_t(mesh.triangles.size());
    } else if (instance.primitive >= 0) {
      const Mesh mesh = tessellate(f.scene.primitives[size_t(instance.primitive)], tolerance);
      draw(f, mesh, instance, material, item);
      item += uint32_t(mesh.triangles.size());
    }
  }
}

void check_size(int width, int height, int samples) {
  if (samples != 1 && samples != 4 && samples != 16)
    throw Error(Code::bad_param, "raster.samples", fmt::format("got {}", samples), "accepted 1, 4, 16");
  if (width < 1 || height < 1 || width > kGuardBand / 4 || height > kGuardBand / 4 ||
      uint64_t(width) * uint64_t(height) > kMostPixels)
    throw Error(Code::limit, "raster.size", fmt::format("got {} x {} px", width, height),
                fmt::format("at least 1 x 1, sides up to {}, {} pixels in all", int(kGuardBand / 4), kMostPixels));
}

}  // namespace

LayeredImage rasterize(const Scene& scene, const Camera& camera, int width, int height, const RasterOptions& options,
                       Progress* progress) {
  check_size(width, height, options.samples);
  const int k = options.samples == 16 ? 4 : options.samples == 4 ? 2 : 1;
  RasterFrame f{scene,
                View(camera, width * k, height * k),
                make_method(shading_methods(), "shading", options.shading),
                make_method(illumination_models(), "illumination", options.illumination),
                scene_lights(scene),
                options.cull_back_faces,
                {}};
  if (progress) progress->begin("rasterizing", "frames", 1);
  Pixel clear{};
  clear.depth = f.view.farthest();
  f.pixels.assign(size_t(width * k) * size_t(height * k), clear);
  draw_all(f);
  LayeredImage out;
  Image picture(width, height, 3);
  for (int y = 0; y < height * k; ++y)
    for (int x = 0; x < width * k; ++x) {
      const Pixel& p = f.pixels[size_t(y) * size_t(width * k) + size_t(x)];
      Rgb c = p.colour;
      if (p.item == ItemBuffer::kNothing) {
        const CameraRay ray =
            camera_ray(camera, (float(x) + 0.5f) / float(k), (float(y) + 0.5f) / float(k), width, height);
        c = scene.environment.shines() ? radiance(scene.environment, ray.direction).v : scene.background.v;
      }
      picture.set_rgb(x / k, y / k, picture.rgb(x / k, y / k) + c / float(k * k));
    }
  out.layers.push_back({"", std::move(picture)});
  const auto layer = [&](const char* name, int channels, auto value) {
    Image& image = out.add(name, width, height, channels);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Pixel& p = f.pixels[size_t(y * k + k / 2) * size_t(width * k) + size_t(x * k + k / 2)];
        for (int c = 0; c < channels; ++c) image.at(x, y)[c] = value(p, c);
      }
  };
  if (options.albedo) layer("albedo", 3, [](const Pixel& p, int c) { return p.albedo[c]; });
  if (options.normal) layer("N", 3, [](const Pixel& p, int c) { return p.normal[c]; });
  if (options.position) layer("P", 3, [](const Pixel& p, int c) { return p.position[c]; });
  if (options.depth)
    layer("Z", 1,
          [&](const Pixel& p, int) { return p.item == ItemBuffer::kNothing ? kInfinity : f.view.distance(p.depth); });
  if (progress) progress->advance();
  return out;
}

ItemBuffer rasterize_items(const Scene& scene, const Camera& camera, int width, int height) {
  ItemBuffer out;
  ItemRasterizer(scene).draw(camera, width, height, out);
  return out;
}

Image rasterize_radiance(const Mesh& mesh, std::span<const Rgb> radiance, const Camera& camera, int width, int height,
                         int samples) {
  Scene scene;
  scene.meshes.push_back(mesh);
  scene.meshes[0].colours.clear();
  for (const Rgb c : radiance) scene.meshes[0].colours.push_back({c.r, c.g, c.b, 1});
  scene.meshes[0].material = 0;
  scene.materials.emplace_back();
  scene.materials[0].unlit = true;
  Instance instance;
  instance.mesh = 0;
  scene.instances.push_back(instance);
  RasterOptions options;
  options.samples = samples;
  return std::move(rasterize(scene, camera, width, height, options).layers[0].image);
}

}  // namespace aktina
