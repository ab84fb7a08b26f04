#include "aktina/raster/rasterize.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/raster/limits.h"
#include "aktina/raster/passes.h"
#include "aktina/raster/resolve.h"

namespace aktina {
namespace {

constexpr uint32_t kVertexPiece = 1024;  // vertices that one task takes
constexpr size_t kMostMethodsPerScene = 65536;

int side_of(int samples) {
  if (samples != 1 && samples != 4 && samples != 16)
    throw Error(Code::bad_param, "raster.samples", fmt::format("got {}", samples), "accepted 1, 4, 16");
  return samples == 16 ? 4 : samples == 4 ? 2 : 1;
}

PipelineSettings settings_of(const Scene& scene, const RasterOptions& options) {
  PipelineSettings s;
  s.method = make_method(shading_methods(), "shading", options.shading);
  s.unlit = make_method(shading_methods(), "shading", "gouraud:perspective=1");
  s.model = make_method(illumination_models(), "illumination", options.illumination);
  s.lights = scene_lights(scene);
  check(options.depth_cue);
  s.cue = options.depth_cue;
  // Here already: a method says what it cannot do.
  s.method->plan(Illuminator(s.model, Surface(), s.lights.lights, s.lights.ambient, Viewer()));
  s.cull = options.cull_back_faces;
  s.surface_layers = options.albedo || options.normal;
  return s;
}

/// Bands that wait for work.
class BandPool {
 public:
  std::unique_ptr<RasterBand> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<RasterBand>();
    std::unique_ptr<RasterBand> band = std::move(free_.back());
    free_.pop_back();
    return band;
  }
  void give_back(std::unique_ptr<RasterBand> band) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(band));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<RasterBand>> free_;
};

/// Time and evaluations since it was made or last asked.
class Lap {
 public:
  /// Adds them.
  void end(double& seconds, uint64_t& evaluations) {
    const auto now = std::chrono::steady_clock::now();
    const uint64_t lit = points_lit_by_this_thread();
    seconds += std::chrono::duration<double>(now - time_).count(), evaluations += lit - lit_;
    time_ = now, lit_ = lit;
  }

 private:
  std::chrono::steady_clock::time_point time_ = std::chrono::steady_clock::now();
  uint64_t lit_ = points_lit_by_this_thread();
};

/// Layer `index` of a picture, with the wanted size; its values are left as they are where it has that already.
Image& layer_at(LayeredImage& out, size_t index, const char* name, int width, int height, int channels) {
  if (out.layers.size() <= index) out.layers.resize(index + 1);
  LayeredImage::Layer& layer = out.layers[index];
  layer.name = name;
  if (layer.image.width != width || layer.image.height != height || layer.image.channels != channels)
    layer.image = Image(width, height, channels);
  return layer.image;
}

}  // namespace

class Rasterizer::Workshop {
 public:
  Workshop(const Scene& scene, const RasterOptions& options)
      : scene_(scene),
        options_(options),
        side_(side_of(options.samples)),
        settings_(settings_of(scene, options)),
        list_(scene) {
    screen_.resize(list_.vertex_count());
    for (uint32_t part = 0; part < list_.parts().size(); ++part) {
      const DrawPart& p = list_.parts()[part];
      for (uint32_t first = 0; first < p.vertex_count; first += kVertexPiece)
        pieces_.push_back(
            {part, p.first_vertex + first, p.first_vertex + std::min(first + kVertexPiece, p.vertex_count)});
    }
    if (list_.parts().size() > kMostMethodsPerScene)
      throw Error(Code::limit, "raster.parts", fmt::format("got {} instances", list_.parts().size()),
                  fmt::format("at most {}", kMostMethodsPerScene));
  }

  void draw(const Camera& camera, int width, int height, LayeredImage& out, Progress* progress) {
    check_picture(camera, width, height);
    check_picture(camera, width * side_, height * side_);
    const View view(camera, width * side_, height * side_);
    Viewer viewer = view.viewer();
    viewer.cue = settings_.cue;
    viewer.cue.eye = camera.position(), viewer.cue.forward = camera.forward();
    const Pipelines pipelines(settings_, list_, viewer);
    if (pipelines.any_radiance) radiance_.light.resize(VertexRadiance::row(padded(list_.vertex_count()), true));
    if (pipelines.any_specular) radiance_.specular.resize(VertexRadiance::row(padded(list_.vertex_count()), true));
    RasterFrame frame{scene_, list_, view, pipelines, screen_, radiance_, chunks_};
    const uint32_t chunks = (list_.triangle_count() + kChunkTriangles - 1) / kChunkTriangles;
    const uint32_t pass = std::max(chunks_per_pass(chunks, pipelines, view), 1U);
    const uint32_t passes = std::max((chunks + pass - 1) / pass, 1U);  // one draws the background of an empty scene
    if (progress) progress->begin("rasterizing", "bands", uint64_t(frame.bands()) * passes);
    Lap lap;
    cost_ = {};
    draw_vertices(frame);
    const PictureLayers layers = prepare(out, width, height);
    bands_.clear();  // of a picture that was cancelled
    bands_.resize(size_t(frame.bands()));
    for (uint32_t p = 0; p < passes; ++p) {
      frame.first_chunk = p * pass;
      chunks_.resize(std::min(pass, chunks - frame.first_chunk));
      build_chunks(frame);
      lap.end(cost_.setup_seconds, cost_.setup_evaluations);
      draw_bands(frame, camera, p + 1 == passes ? &layers : nullptr, out, progress);
      lap.end(cost_.pixel_seconds, cost_.pixel_evaluations);
    }
  }

  const FrameCost& cost() const { return cost_; }

 private:
  struct Piece {
    uint32_t part, begin, end;
  };

  void draw_vertices(const RasterFrame& frame) {
    parallel_for(pieces_.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Piece& piece = pieces_[i];
        project_vertices(list_, frame.view, piece.begin, piece.end, screen_);
        light_vertices(list_, list_.parts()[piece.part], frame.pipelines.all[frame.pipelines.of_part[piece.part]],
                       piece.begin, piece.end, radiance_);
      }
    });
  }

  void build_chunks(const RasterFrame& frame) {
    parallel_for(chunks_.size(), 1, [&](size_t begin, size_t end) {
      for (size_t c = begin; c < end; ++c) build_chunk(frame, uint32_t(c));
    });
    for (const TriangleChunk& chunk : chunks_) cost_.triangles += chunk.count;
  }

  PictureLayers prepare(LayeredImage& out, int width, int height) const {
    size_t count = 1;
    out.layers.resize(1 + size_t(options_.albedo) + size_t(options_.normal) + size_t(options_.position) +
                      size_t(options_.depth));
    layer_at(out, 0, "", width, height, 3);
    PictureLayers layers;
    if (options_.albedo) layers.albedo = &layer_at(out, count++, "albedo", width, height, 3);
    if (options_.normal) layers.normal = &layer_at(out, count++, "N", width, height, 3);
    if (options_.position) layers.position = &layer_at(out, count++, "P", width, height, 3);
    if (options_.depth) layers.depth = &layer_at(out, count++, "Z", width, height, 1);
    return layers;
  }

  /// @param layers  where this is the last pass
  void draw_bands(const RasterFrame& frame, const Camera& camera, const PictureLayers* layers, LayeredImage& out,
                  Progress* progress) {
    const auto sky = [&](int x, int y) {
      const CameraRay ray =
          camera_ray(camera, float(x) + 0.5f, float(y) + 0.5f, frame.view.width(), frame.view.height());
      return radiance(scene_.environment, ray.direction).v;
    };
    const bool varies = scene_.environment.shines();
    const Background background{varies ? Rgb() : scene_.background.v, varies, side_ > 1, sky};
    const std::vector<uint32_t> order = fullest_first(frame);
    std::atomic<size_t> next{0};
    parallel_for(std::min(order.size(), size_t(thread_count())), 1, [&](size_t, size_t) {
      for (size_t i = next++; i < order.size(); i = next++) {
        if (progress) progress->throw_if_cancelled();
        const int index = int(order[i]);
        std::unique_ptr<RasterBand>& band = bands_[order[i]];
        if (!band) start_band(frame, index, band);
        draw_opaque(frame, index, *band);
        if (layers) {
          finish_band(frame, index, background, *band);
          resolve(frame, background, *layers, *band, out);
          pool_.give_back(std::move(band));
        }
        if (progress) progress->advance();
      }
    });
  }

  void start_band(const RasterFrame& frame, int index, std::unique_ptr<RasterBand>& band) {
    band = pool_.take();
    band->surface_layers = settings_.surface_layers;
    clear_band(frame, index, *band);
  }

  /// Bands, those of most triangles first: so the threads come to their end together.
  std::vector<uint32_t> fullest_first(const RasterFrame& frame) const {
    std::vector<size_t> triangles(size_t(frame.bands()));
    for (const TriangleChunk& chunk : chunks_)
      for (size_t b = 0; b < triangles.size(); ++b) triangles[b] += chunk.bands[b].size() + chunk.blended[b].size();
    std::vector<uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return triangles[a] > triangles[b]; });
    return order;
  }

  void resolve(const RasterFrame& frame, const Background& background, const PictureLayers& layers,
               const RasterBand& band, LayeredImage& out) const {
    if (side_ == 1) {
      resolve_colour(band, frame.view, background.uniform, out.layers[0].image);
    } else {
      average_colour(band, side_, out.layers[0].image);
    }
    if (out.layers.size() > 1) resolve_layers(band, frame.view, side_, layers);
  }

  const Scene& scene_;
  RasterOptions options_;
  int side_;
  PipelineSettings settings_;
  DrawList list_;
  std::vector<Piece> pieces_;
  ScreenVertices screen_;
  VertexRadiance radiance_;
  std::vector<TriangleChunk> chunks_;
  BandPool pool_;
  std::vector<std::unique_ptr<RasterBand>> bands_;  // in the making
  FrameCost cost_;
};

Rasterizer::Rasterizer(const Scene& scene, const RasterOptions& options)
    : workshop_(std::make_unique<Workshop>(scene, options)) {}
Rasterizer::~Rasterizer() = default;
void Rasterizer::draw(const Camera& camera, int width, int height, LayeredImage& out, Progress* progress) {
  workshop_->draw(camera, width, height, out, progress);
}
const FrameCost& Rasterizer::last_frame() const { return workshop_->cost(); }

LayeredImage rasterize(const Scene& scene, const Camera& camera, int width, int height, const RasterOptions& options,
                       Progress* progress) {
  check_picture(camera, width, height);
  LayeredImage out;
  Rasterizer(scene, options).draw(camera, width, height, out, progress);
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
  scene.materials[0].double_sided = true;
  Instance instance;
  instance.mesh = 0;
  scene.instances.push_back(instance);
  RasterOptions options;
  options.samples = samples;
  return std::move(rasterize(scene, camera, width, height, options).layers[0].image);
}

}  // namespace aktina
