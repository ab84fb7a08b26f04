// Two passes: radiosity has carried the light between diffuse surfaces; rays from the eye follow mirrors and glass to
// the first diffuse surface. What that one shows is its share of the light straight from lamps, sharp, by shadow rays,
// and of all other light as the solution has it, smooth over the patch, both times its texture. With `gather` the
// other light, too, is found anew: a ray looks where it comes from, and takes the solution's light there.
// Cost: one path without branches and one shadow ray a sample; with gather one ray more, and noise. Weakness: light
// that mirrors and glass throw on diffuse surfaces (caustics) is not in the solution; rough reflections of surfaces
// that have a matt body are left out, those of metals are sampled.
//
// J. Wallace, M. Cohen, D. Greenberg, "A Two-pass Solution to the Rendering Equation: a Synthesis of Ray Tracing and
// Radiosity Methods", SIGGRAPH 1987; direct light apart: P. Shirley, "A Ray Tracing Method for Illumination Calculation
// in Diffuse-Specular Scenes", Graphics Interface 1990; final gather: M. Reichert, "A Two-Pass Radiosity Method Driven
// by Lights and Viewer Position", Cornell University 1992.
#include <fmt/core.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/image/file_format.h"
#include "aktina/radiosity/display/patch_scene.h"
#include "aktina/radiosity/specular/specular.h"
#include "aktina/trace/camera_rays.h"
#include "aktina/trace/offset.h"
#include "aktina/trace/sampler.h"
#include "aktina/trace/shadow_rays.h"

namespace aktina {
namespace {

constexpr int kTile = 16;  // px
constexpr int kMostBounces = 16;
constexpr int kMostLayers = 64;  // surfaces that a path looks through, at most

// Dimensions of a sample's numbers; those of a bounce follow one another.
enum Dimension : uint32_t { kPixel, kLampChoice, kLampPlace, kDirection, kLobe, kAlpha, kGather, kEach = 8 };

struct Path {
  Ray ray;
  Rgb throughput{1};
  SampleSequence sequence;
  uint32_t query = 0, bounces = 0, layers = 0;
  bool gathers = false;  // has left a diffuse surface: takes the solution's light where it arrives
  uint32_t dimension(Dimension d) const { return d + kEach * bounces; }
};

class Tile {
 public:
  Tile(const PatchScene& patches, const RayScene& rays, const Solution& solution, bool gather, std::span<Rgb> sums)
      : patches_(patches), rays_(rays), solution_(solution), gather_(gather), sums_(sums) {}

  void run(std::vector<Path>& paths) {
    Coherence coherence = Coherence::coherent;
    while (!paths.empty()) {
      size_t alive = 0;
      for (size_t first = 0; first < paths.size(); first += kPacket) {
        const size_t n = std::min(paths.size() - first, size_t(kPacket));
        RayPacket packet{};
        HitPacket hits;
        for (size_t i = 0; i < n; ++i) packet.set(int(i), paths[first + i].ray);
        rays_.accelerator->intersect(packet, (1U << n) - 1, hits, coherence);
        for (size_t i = 0; i < n; ++i)
          if (advance(paths[first + i], hits.at(int(i)))) paths[alive++] = paths[first + i];
      }
      paths.resize(alive);
      paths.insert(paths.end(), gathering_.begin(), gathering_.end());
      gathering_.clear();
      shadows_.trace(rays_, coherence, [&](const ShadowRay& ray) { sums_[ray.query] += ray.light; });
      coherence = Coherence::incoherent;
    }
  }

 private:
  /// One hit of one path. @return  whether the path goes on
  bool advance(Path& path, const Hit& hit) {
    if (!hit) {
      if (path.gathers) return false;  // the sky is direct light
      const EnvironmentLight& sky = rays_.scene.environment;
      const Rgb seen = sky.shines() ? radiance(sky, path.ray.direction).v : rays_.scene.background.v;
      sums_[path.query] += path.throughput * seen;
      return false;
    }
    ShadingPoint point;
    rays_.surfaces.shade(path.ray, hit, true, point);
    if (point.alpha < 1 && path.sequence.random(path.dimension(kAlpha) + 131 * path.layers) >= point.alpha) {
      path.ray.origin = offset_point(point.position, -point.geometric);
      path.ray.near = 0;
      return ++path.layers < kMostLayers;
    }
    if (!path.gathers) sums_[path.query] += path.throughput * point.emission.v;
    const bool lit = point.front || point.material->double_sided;  // the backs of others are black
    const Rgb matt = is_black(point.surface->kd) ? Rgb(0) : matt_reflectance(*point.surface);
    if (path.gathers) {
      if (lit) sums_[path.query] += path.throughput * matt * irradiance(point, hit, true) * float(kInvPi);
      return false;
    }
    if (lit && !is_black(matt)) {
      if (gather_)
        gather(path, point, matt);
      else
        sums_[path.query] += path.throughput * matt * irradiance(point, hit, false) * float(kInvPi);
      add_direct(path, point, matt);
    }
    return path.bounces < kMostBounces && !point.scattering->black() && mirror(path, point, is_black(matt));
  }

  /// Sends a ray, by the cosine, to where the indirect light comes from.
  void gather(const Path& from, const ShadingPoint& point, Rgb matt) {
    const Vec3 wi = Frame(point.normal).to_world(sample_cosine_hemisphere(from.sequence.pair(from.dimension(kGather))));
    if (!(dot(wi, point.geometric) > 0)) return;
    Path path = from;
    path.gathers = true;
    path.throughput *= matt;
    path.ray = {offset_point(point.position, point.geometric), wi};
    gathering_.push_back(path);
  }

  /// The solution's, interpolated over the patch. @param with_direct  light straight from lamps, too
  Rgb irradiance(const ShadingPoint& point, const Hit& hit, bool with_direct) const {
    const auto& v = patches_.vertices[hit.instance][hit.triangle];
    const bool mirrored = glm::determinant(Mat3(rays_.scene.instances[hit.instance].to_world)) < 0;
    const float w[3] = {1 - hit.u - hit.v, mirrored ? hit.v : hit.u, mirrored ? hit.u : hit.v};
    const auto& all = point.front ? solution_.vertex_irradiances : solution_.vertex_back_irradiances;
    const auto& direct = point.front ? solution_.vertex_direct_irradiances : solution_.vertex_back_direct_irradiances;
    Rgb h;
    for (size_t k = 0; k < 3; ++k) h += (with_direct ? all[v[k]].v : all[v[k]].v - direct[v[k]].v) * w[k];
    return clamped(h, 0, kInfinity);
  }

  void add_direct(const Path& path, const ShadingPoint& point, Rgb matt) {
    if (rays_.lights.empty()) return;
    const ArrivingLight light = rays_.lights.sample(point.position, path.sequence.single(path.dimension(kLampChoice)),
                                                    path.sequence.pair(path.dimension(kLampPlace)));
    const float cosine = dot(light.wi, point.normal);
    if (is_black(light.e_perp) || !(cosine > 0 && dot(light.wi, point.geometric) > 0)) return;
    shadows_.add({shadow_ray(offset_point(point.position, point.geometric), light.target, light.distant),
                  path.throughput * matt * light.e_perp * (cosine * float(kInvPi)), path.query, kNothing, false});
  }

  /// Follows the interface's reflection or refraction. What is drawn from a matt body ends here: the body's light has
  /// been counted.
  bool mirror(Path& path, const ShadingPoint& point, bool only_interface) const {
    const Frame frame(point.normal);
    const ScatterSample s =
        point.scattering->sample(frame.to_local(point.wo), path.sequence.pair(path.dimension(kDirection)),
                                 path.sequence.random(path.dimension(kLobe)), !point.front);
    if (is_black(s.weight) || (s.pdf > 0 && !only_interface)) return false;
    const Vec3 wi = frame.to_world(s.wi);
    const float side = dot(wi, point.geometric);
    if (!(side * s.wi.z > 0)) return false;
    path.throughput *= s.weight;
    path.ray = {offset_point(point.position, side > 0 ? point.geometric : -point.geometric),
                normalize_or(wi, point.normal)};
    ++path.bounces;
    return true;
  }

  const PatchScene& patches_;
  const RayScene& rays_;
  const Solution& solution_;
  bool gather_;
  std::span<Rgb> sums_;
  std::vector<Path> gathering_;
  ShadowRays shadows_{true};
};

class Picture {
 public:
  Picture(const Scene& scene, const Solution& solution, bool gather, const Camera& camera, int width, int height)
      : solution_(solution),
        gather_(gather),
        patches_(scene, solution),
        rays_(patches_.scene, {}),
        camera_(camera, width, height),
        width_(width),
        height_(height),
        sums_(size_t(width) * size_t(height)) {}

  /// One more sample a pixel. The same values for any number of threads: a pixel belongs to one tile.
  void add_sample(int index, uint32_t seed, Progress* progress) {
    const int columns = (width_ + kTile - 1) / kTile, rows = (height_ + kTile - 1) / kTile;
    parallel_for(size_t(columns) * size_t(rows), 1, [&](size_t begin, size_t end) {
      for (size_t t = begin; t < end; ++t) {
        std::vector<Path> paths = tile(int(t) % columns * kTile, int(t) / columns * kTile, uint32_t(index), seed);
        Tile(patches_, rays_, solution_, gather_, sums_).run(paths);
        if (progress) progress->advance();
      }
    });
  }

  LayeredImage after(int samples) const {
    LayeredImage picture;
    Image& image = picture.add("", width_, height_, 3);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) image.set_rgb(x, y, sums_[pixel(x, y)] * (1 / float(samples)));
    return picture;
  }

 private:
  size_t pixel(int x, int y) const { return size_t(y) * size_t(width_) + size_t(x); }

  std::vector<Path> tile(int left, int top, uint32_t index, uint32_t seed) const {
    std::vector<Path> paths;
    for (int y = top; y < std::min(top + kTile, height_); ++y)
      for (int x = left; x < std::min(left + kTile, width_); ++x) {
        Path path;
        path.query = uint32_t(pixel(x, y));
        path.sequence = {hash_combine(seed, path.query), index};
        const Vec2 within = path.sequence.pair(kPixel);
        path.ray = camera_.at(float(x) + within.x, float(y) + within.y);
        paths.push_back(path);
      }
    return paths;
  }

  const Solution& solution_;
  bool gather_;
  PatchScene patches_;
  RayScene rays_;
  CameraRays camera_;
  int width_, height_;
  std::vector<Rgb> sums_;
};

class TwoPass final : public SpecularMethod {
 public:
  explicit TwoPass(bool gather) : gather_(gather) {}
  LayeredImage render(const Scene& scene, const Solution& solution, const Camera& camera, int width, int height,
                      const TwoPassOptions& options, Progress* progress) const override {
    if (width < 1 || height < 1 || uint64_t(width) * uint64_t(height) > kMostPixels)
      throw Error(Code::limit, "picture", fmt::format("{} x {} pixels", width, height),
                  fmt::format("accepted 1 .. {} in all", kMostPixels));
    if (options.samples < 1)
      throw Error(Code::bad_param, "samples", fmt::format("got {}", options.samples), "1 or more");
    Picture picture(scene, solution, gather_, camera, width, height);
    const int columns = (width + kTile - 1) / kTile, rows = (height + kTile - 1) / kTile;
    if (progress) progress->begin("two passes", "tiles", uint64_t(options.samples) * uint64_t(columns * rows));
    int samples = 0;
    while (samples < options.samples && !(progress && progress->cancelled())) {
      picture.add_sample(samples, options.seed, progress);
      ++samples;
      if (options.each_pass) options.each_pass(picture.after(samples), samples);
    }
    if (samples == 0) throw Error(Code::cancelled, "two_pass", "cancelled before the first sample");
    return picture.after(samples);
  }

 private:
  bool gather_;
};

constexpr Param kParams[] = {{"gather", "1",
                              "1: indirect light by a ray for each sample (final gather); 0: as the solution has it", 0,
                              0, 1, true}};

}  // namespace

extern constinit const Method<std::unique_ptr<SpecularMethod>> two_pass_specular = {
    {"two_pass", "Two-pass rendering", "wallace1987",
     "Radiosity between diffuse surfaces, rays for mirrors, glass and sharp direct shadows; no caustics.", kParams},
    [](const ParamSet& p) -> std::unique_ptr<SpecularMethod> { return std::make_unique<TwoPass>(p["gather"] != 0); }};

}  // namespace aktina
