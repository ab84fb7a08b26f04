#include "aktina/render/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/illumination/energy.h"
#include "aktina/image/tone_map.h"
#include "aktina/raster/shading/shading_method.h"
#include "aktina/render/catalogue.h"
#include "aktina/render/job_report.h"
#include "aktina/render/picture_view.h"
#include "aktina/render/study/claims.h"
#include "aktina/render/study/growth.h"
#include "aktina/render/study/instructions.h"
#include "aktina/render/study/quality.h"
#include "aktina/render/study/runs.h"
#include "aktina/render/study/timing.h"
#include "aktina/scene/scene_lights.h"
#include "aktina/scene/tessellate.h"

namespace aktina {
namespace {

constexpr int kWidth = 480;           // px, where no size is given
constexpr int kFrames = 4;            // of the turn
constexpr float kTurn = 0.0087266f;   // rad, half a degree a frame
constexpr int kReferenceFactor = 16;  // samples of a traced reference, over the methods'

/// Pictures of the turn: the first is the view itself.
std::vector<Image> turn(const StudyWork& work, const Variant& variant, int samples) {
  std::vector<Image> frames;
  const Point3 centre = bounds(work.scene).centre();
  for (int i = 0; i < kFrames; ++i)
    frames.push_back(
        variant.draw(turned(work.camera, centre, float(i) * kTurn), work.width, work.height, samples, work.progress));
  return frames;
}

struct Reference {
  std::vector<Image> frames;
  Image highlights;  // mask; empty where the family has no use for it
};

/// Where the scene's highlights are: what its lamps add to a matt picture of it.
Image highlights(const StudyWork& work) {
  const auto draw = [&](const char* illumination) {
    StudyOptions options = work.options;
    options.illumination = illumination;
    const Variant variant(work.scene, find_study_family("shading"), "phong", options);
    return variant.draw(work.camera, work.width, work.height, 16, work.progress);
  };
  return highlight_mask(draw(work.options.illumination.c_str()), draw("lambert"), work.study.exposure);
}

Reference draw_reference(StudyWork& work, const SmoothEdges& edges) {
  work.progress.begin("drawing the reference", "pictures", 1);
  const Variant variant(work.scene, work.family, work.reference, work.options);
  Reference reference{turn(work, variant, work.reference_samples), {}};
  Study& study = work.study;
  study.reference_picture = reference.frames[0];
  study.exposure = automatic_exposure(study.reference_picture);
  if (work.family.rasterized) {
    reference.highlights = highlights(work);
    edges.measure(variant.draw(work.camera, work.width, work.height, 1, work.progress), study.exposure,
                  study.reference_edges);
  }
  work.progress.advance();
  return reference;
}

void measure_quality(const StudyWork& work, const SmoothEdges& edges, const Reference& reference, MethodStudy& m) {
  const Variant variant(work.scene, work.family, m.choice, work.options);
  std::vector<Image> frames = turn(work, variant, work.options.samples);
  const float exposure = work.study.exposure;
  m.quality = compare_pictures(frames[0], reference.frames[0], exposure);
  m.quality.flicker = flicker(frames, reference.frames, exposure);
  if (work.family.rasterized) {
    m.quality.highlight_rmse = masked_rmse(frames[0], reference.frames[0], reference.highlights, exposure);
    edges.measure(variant.draw(work.camera, work.width, work.height, 1, work.progress), exposure, m.quality);
  }
  m.picture = std::move(frames[0]);
}

void draw_methods(StudyWork& work, const SmoothEdges& edges, const Reference& reference) {
  work.progress.begin("drawing", "methods", work.study.methods.size());
  for (MethodStudy& m : work.study.methods) {
    try {
      measure_quality(work, edges, reference, m);
    } catch (const Error& error) {
      if (error.code() != Code::unsupported && error.code() != Code::limit) throw;
      m.failure = error.what();
    }
    work.progress.advance();
  }
}

void count_work(const StudyWork& work, const Variant& variant, MethodStudy& m) {
  Variant::Frames frames(variant, work.camera, work.width, work.height);
  frames.draw(work.progress);
  const InstructionCounter counter;
  frames.draw(work.progress);
  const FrameCost& cost = frames.cost();
  const auto pixels = double(work.study.covered_pixels);
  if (const auto count = counter.count(); count && pixels > 0)
    m.cost.instructions_per_pixel = double(*count) / pixels, work.study.counts_instructions = true;
  if (pixels > 0) m.cost.pixel_evaluations = double(cost.pixel_evaluations) / pixels;
  if (cost.triangles > 0) m.cost.setup_evaluations = double(cost.setup_evaluations) / double(cost.triangles);
  if (pixels > 0) m.cost.ns_per_pixel = m.cost.times[0].pixel_seconds / pixels * 1e9;
  if (cost.triangles > 0) m.cost.ns_per_triangle = m.cost.times[0].setup_seconds / double(cost.triangles) * 1e9;
}

/// By the published form, of shading methods.
void count_operations(const StudyWork& work, MethodStudy& m) {
  const auto method = make_method(shading_methods(), "shading", m.choice);
  const IlluminationModel model = make_method(illumination_models(), "illumination", work.options.illumination);
  const Illuminator light(model, Surface(), {}, Rgb(0), Viewer());
  const ShadingPlan plan = method->plan(light);
  m.cost.pixel_operations = operations_per_pixel(m.id, plan, double(scene_lights(work.scene).lights.size()));
  m.cost.triangle_operations = operations_per_triangle(m.id, plan);
}

Energy energy_of(const std::string& choice, const Surface& surface) {
  const IlluminationModel model = make_method(illumination_models(), "illumination", choice);
  const auto seen = [&](double degrees) {
    return double(luminance(albedo(model, surface, float(std::cos(degrees * kPi / 180)))));
  };
  return {seen(0), seen(60), seen(85), double(reciprocity_error(model, surface).error)};
}

void measure_energy(StudyWork& work) {
  if (work.scene.instances.empty()) return;
  const Surface surface = surface_of(work.scene.material_of(work.scene.instances[0]));
  work.progress.begin("measuring energy", "models", work.study.methods.size());
  for (MethodStudy& m : work.study.methods) {
    work.progress.throw_if_cancelled();
    m.energy = energy_of(m.choice, surface);
    work.progress.advance();
  }
}

void measure_cost(StudyWork& work) {
  std::vector<std::unique_ptr<Variant>> all;
  std::vector<const Variant*> bare;
  for (const MethodStudy& m : work.study.methods) {
    if (m.failure.empty()) all.push_back(std::make_unique<Variant>(work.scene, work.family, m.choice, work.options));
    bare.push_back(m.failure.empty() ? all.back().get() : nullptr);
  }
  std::vector<int> threads = {1};
  if (work.threads > 1) threads.push_back(work.threads);
  work.progress.begin("timing", "frames", threads.size() * size_t(work.options.rounds + 1) * bare.size());
  for (const int count : threads) {
    const auto times = race(bare, work.camera, work.width, work.height, work.options.rounds, count, work.progress);
    for (size_t i = 0; i < times.size(); ++i)
      if (bare[i]) work.study.methods[i].cost.times.push_back(times[i]);
  }
  set_thread_count(1);
  for (size_t i = 0; i < bare.size(); ++i) {
    if (!bare[i]) continue;
    if (bare[i]->rasterized()) count_work(work, *bare[i], work.study.methods[i]);
    if (work.family.id == "shading") count_operations(work, work.study.methods[i]);
  }
}

double seconds_of(const MethodStudy& m) { return m.cost.times.empty() ? kNotMeasured : m.cost.times[0].seconds; }

/// The Pareto front of error and time on one thread.
void find_best(std::vector<MethodStudy>& methods) {
  for (MethodStudy& m : methods) {
    m.best = std::isfinite(m.quality.rmse) && std::isfinite(seconds_of(m)) &&
             std::none_of(methods.begin(), methods.end(), [&](const MethodStudy& o) {
               return o.quality.rmse <= m.quality.rmse && seconds_of(o) <= seconds_of(m) &&
                      (o.quality.rmse < m.quality.rmse || seconds_of(o) < seconds_of(m));
             });
  }
}

std::string settings(const StudyWork& work) {
  std::string line = fmt::format("study {} --family {}", work.study.report.scene_file, work.family.id);
  if (!work.options.methods.empty()) line += fmt::format(" --methods {}", fmt::join(work.options.methods, ","));
  return line + fmt::format(" --reference {} --illumination {} --size {}x{} --samples {} --seed {}", work.reference,
                            work.options.illumination, work.width, work.height, work.options.samples,
                            work.options.seed);
}

void measure(StudyWork& work) {
  Stopwatch watch;
  const SmoothEdges edges(work.scene, work.camera, work.width, work.height);
  work.study.covered_pixels = edges.covered_pixels();
  const Reference reference = draw_reference(work, edges);
  draw_methods(work, edges, reference);
  work.study.report.time("draw", watch.lap());
  measure_cost(work);
  work.study.report.time("time", watch.lap());
  find_best(work.study.methods);
  if (work.family.id == "illumination") measure_energy(work);
  if (work.options.growth && work.family.rasterized) measure_growth(work);
  work.study.report.time("grow", watch.lap());
}

}  // namespace

std::vector<MethodStudy> chosen_methods(std::string_view family, const StudyOptions& options) {
  const Family& table = find_family(family);
  std::vector<std::string> choices = options.methods;
  if (choices.empty())
    for (const MethodInfo* method : table.methods) choices.emplace_back(method->id);
  std::vector<MethodStudy> all;
  for (const std::string& choice : choices) {
    const MethodInfo& row = find_method(table, parse_method(choice).id);
    MethodStudy& m = all.emplace_back();
    m.choice = choice, m.id = row.id, m.title = row.title, m.summary = row.summary, m.cite = row.cite;
  }
  return all;
}

Study study(const Scene& given, const StudyOptions& options, Progress& progress) {
  if (const RunFamily* runs = find_run_family(options.family)) return study_by_runs(given, options, *runs, progress);
  const StudyFamily& family = find_study_family(options.family);
  Study result;
  result.methods = chosen_methods(family.id, options);
  const TessellatedScene scene(given);
  const Camera& camera = chosen_camera(*scene, options.camera);
  const ThreadsKept threads;
  const std::string reference = options.reference.empty() ? std::string(family.reference) : options.reference;
  int width = options.width, height = options.height;
  fill_size(camera, kWidth, width, height);
  StudyWork work{*scene,          family,    options,         camera,   width, height,
                 threads.count(), reference, options.samples, progress, result};
  if (options_of(family, reference, options).method != "raster") work.reference_samples *= kReferenceFactor;
  result.scene = display(Path(given.source).filename());
  result.family = family.id, result.reference = reference;
  result.report = begin_report(given, options.seed);
  result.report.settings = settings(work);
  result.triangles = triangle_count(*scene);
  try {
    measure(work);
  } catch (const Error& error) {
    if (error.code() != Code::cancelled || result.methods[0].picture.empty()) throw;
    result.report.complete = false;
  }
  judge_claims(result);
  return result;
}

}  // namespace aktina
