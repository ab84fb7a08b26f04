#include "aktina/render/study/growth.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "aktina/render/study/quality.h"
#include "aktina/render/study/timing.h"

namespace aktina {
namespace {

constexpr uint64_t kMostTriangles = 400000;  // of a level
constexpr int kLevels = 3, kRounds = 4, kLargestSide = 2048;

/// Vertices in the middle of edges, made once for both sides.
class MidEdges {
 public:
  explicit MidEdges(Mesh& mesh) : mesh_(mesh) {}

  uint32_t of(uint32_t a, uint32_t b) {
    const auto [at, fresh] = known_.try_emplace(std::minmax(a, b), uint32_t(mesh_.positions.size()));
    if (fresh) add(a, b);
    return at->second;
  }

 private:
  template <class T>
  static void average(std::vector<T>& values, uint32_t a, uint32_t b) {
    if (!values.empty()) values.push_back((values[a] + values[b]) * 0.5f);
  }

  void add(uint32_t a, uint32_t b) {
    average(mesh_.positions, a, b);
    average(mesh_.uv[0], a, b), average(mesh_.uv[1], a, b);
    average(mesh_.colours, a, b);
    if (!mesh_.normals.empty()) {
      const Vec3 n = mesh_.normals[a] + mesh_.normals[b];
      mesh_.normals.push_back(normalize_or(n, mesh_.normals[a]));
    }
    if (!mesh_.tangents.empty()) {
      const Vec4 t = mesh_.tangents[a], u = mesh_.tangents[b];
      mesh_.tangents.emplace_back(normalize_or(Vec3(t) + Vec3(u), Vec3(t)), t.w);
    }
  }

  Mesh& mesh_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> known_;
};

Mesh subdivided(const Mesh& mesh) {
  Mesh out = mesh;
  out.triangles.clear(), out.triangle_face.clear();
  MidEdges middle(out);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const uint32_t ab = middle.of(a, b), bc = middle.of(b, c), ca = middle.of(c, a);
    for (const auto& part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      out.triangles.push_back(part);
      if (!mesh.triangle_face.empty()) out.triangle_face.push_back(mesh.triangle_face[t]);
    }
  }
  return out;
}

/// Variants of the methods that can draw the scene; null for the others.
std::vector<std::unique_ptr<Variant>> variants(const StudyWork& work, const Scene& scene) {
  std::vector<std::unique_ptr<Variant>> all;
  for (const MethodStudy& m : work.study.methods)
    all.push_back(m.failure.empty() ? std::make_unique<Variant>(scene, work.family, m.choice, work.options) : nullptr);
  return all;
}

std::vector<FrameTime> times(const StudyWork& work, const std::vector<std::unique_ptr<Variant>>& all, int width,
                             int height) {
  std::vector<const Variant*> bare;
  for (const auto& variant : all) bare.push_back(variant.get());
  return race(bare, work.camera, width, height, std::min(kRounds, work.options.rounds), 1, work.progress);
}

GrowthPoint point(const FrameTime& time, uint64_t triangles, uint64_t pixels) {
  return {triangles, pixels, time.seconds, time.setup_seconds, time.pixel_seconds};
}

void over_level(StudyWork& work, const Scene& scene) {
  const auto all = variants(work, scene);
  const std::vector<FrameTime> time = times(work, all, work.width, work.height);
  const auto draw = [&](const Variant& variant, int samples) {
    return variant.draw(work.camera, work.width, work.height, samples, work.progress);
  };
  const Variant reference(scene, work.family, work.reference, work.options);
  const Image right = draw(reference, work.reference_samples);
  for (size_t i = 0; i < all.size(); ++i) {
    if (!all[i]) continue;
    GrowthPoint p = point(time[i], triangle_count(scene), uint64_t(work.width) * uint64_t(work.height));
    p.rmse = compare_pictures(draw(*all[i], work.options.samples), right, work.study.exposure).rmse;
    work.study.methods[i].growth.over_triangles.push_back(p);
    work.progress.advance();
  }
}

void over_size(StudyWork& work, double scale) {
  const int width = std::max(1, int(work.width * scale)), height = std::max(1, int(work.height * scale));
  const auto all = variants(work, work.scene);
  const std::vector<FrameTime> time = times(work, all, width, height);
  for (size_t i = 0; i < all.size(); ++i) {
    if (!all[i]) continue;
    work.study.methods[i].growth.over_pixels.push_back(
        point(time[i], triangle_count(work.scene), uint64_t(width) * uint64_t(height)));
  }
}

void fit(Growth& growth) {
  const auto slope = [](const std::vector<GrowthPoint>& points, auto x, auto y) {
    std::vector<double> xs, ys;
    for (const GrowthPoint& p : points) xs.push_back(double(p.*x)), ys.push_back(p.*y);
    return log_log_slope(xs, ys);
  };
  growth.time_over_triangles = slope(growth.over_triangles, &GrowthPoint::triangles, &GrowthPoint::seconds);
  growth.error_over_triangles = slope(growth.over_triangles, &GrowthPoint::triangles, &GrowthPoint::rmse);
  growth.time_over_pixels = slope(growth.over_pixels, &GrowthPoint::pixels, &GrowthPoint::seconds);
}

}  // namespace

Scene subdivided(const Scene& scene) {
  Scene out = scene;
  for (Mesh& mesh : out.meshes) mesh = subdivided(mesh);
  return out;
}

double log_log_slope(std::span<const double> x, std::span<const double> y) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0 && y[i] > 0)) continue;
    const double u = std::log(x[i]), v = std::log(y[i]);
    n += 1, sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  const double spread = n * sxx - sx * sx;
  return n >= 2 && spread > 1e-12 ? (n * sxy - sx * sy) / spread : kNotMeasured;
}

void measure_growth(StudyWork& work) {
  std::vector<const Scene*> levels = work.options.levels;
  std::vector<std::unique_ptr<Scene>> own;
  if (levels.empty()) {
    levels.push_back(&work.scene);
    while (int(levels.size()) < kLevels && triangle_count(*levels.back()) * 4 <= kMostTriangles) {
      own.push_back(std::make_unique<Scene>(subdivided(*levels.back())));
      levels.push_back(own.back().get());
    }
  }
  std::vector<double> scales = {0.5, 1};
  if (std::max(work.width, work.height) * 2 <= kLargestSide) scales.push_back(2);
  const size_t frames = size_t(std::min(kRounds, work.options.rounds) + 1);
  work.progress.begin("growing", "measurements",
                      ((levels.size() + scales.size()) * frames + levels.size()) * work.study.methods.size());
  for (const Scene* level : levels) over_level(work, *level);
  for (const double scale : scales) over_size(work, scale);
  for (MethodStudy& m : work.study.methods) fit(m.growth);
}

}  // namespace aktina
