// aktina study: the methods of a family on one view, held against a reference, timed and counted.
#include "aktina/render/study/study.h"

#include <fmt/format.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/render/study/output.h"
#include "aktina/render/study/paper.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

/// "gouraud,hemicube:resolution=64,rotate=1": what has "=" without ":" goes on with the parameters before it.
std::vector<std::string> split_methods(const std::string& text) {
  std::vector<std::string> methods;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, end - at);
    if (!methods.empty() && part.find('=') != part.npos && part.find(':') == part.npos)
      methods.back() += "," + part;
    else if (!part.empty())
      methods.push_back(part);
    at = end + 1;
  }
  return methods;
}

StudyOptions read_options(const Arguments& arguments) {
  StudyOptions options;
  options.family = arguments.text("family");
  options.methods = split_methods(arguments.text("methods"));
  options.reference = arguments.text("reference");
  options.illumination = arguments.text("illumination");
  options.samples = int(arguments.whole("samples"));
  options.rounds = int(arguments.whole("rounds"));
  options.seed = uint32_t(arguments.whole("seed"));
  options.growth = !arguments.given("no-growth");
  read_size(arguments.text("size"), options.width, options.height);
  return options;
}

/// The least error of each method, and what it took.
std::string run_summary(const Study& study) {
  std::string text = fmt::format("{:<28} {:>12} {:>12}  {}\n", study.scene + ": " + study.family, "least error", "s",
                                 study.error_name);
  for (const MethodStudy& m : study.methods) {
    const auto best = std::min_element(m.runs.begin(), m.runs.end(),
                                       [](const StudyRun& a, const StudyRun& b) { return a.error < b.error; });
    text += best == m.runs.end()
                ? fmt::format("{:<28} {}\n", m.choice, m.failure)
                : fmt::format("{:<28} {:>12.4g} {:>12.4g}  {}\n", m.choice, best->error, best->seconds, best->name());
  }
  return text;
}

std::string summary(const Study& study) {
  if (!study.error_name.empty()) return run_summary(study);
  std::string text =
      fmt::format("{:<28} {:>10} {:>10} {:>12}\n", study.scene + ": " + study.family, "RMSE", "FLIP", "ms a frame");
  for (const MethodStudy& m : study.methods) {
    const double ms = m.cost.times.empty() ? kNotMeasured : m.cost.times[0].seconds * 1e3;
    text += m.failure.empty() ? fmt::format("{:<28} {:>10.4g} {:>10.4g} {:>12.4g}{}\n", m.choice, m.quality.rmse,
                                            m.quality.flip, ms, m.best ? "  *" : "")
                              : fmt::format("{:<28} {}\n", m.choice, m.failure);
  }
  return text + "* no other method is both quicker and nearer to the reference\n";
}

std::vector<Study> study_of(const Arguments& arguments, Session& session) {
  StudyOptions options = read_options(arguments);
  if (arguments.given("paper")) {
    session.begin_work();
    return study_paper(options, session.progress());
  }
  const LoadedScene loaded = load(arguments, session);
  options.camera = find_camera(loaded.scene, arguments.text("camera"));
  session.begin_work();
  std::vector<Study> studies;
  studies.push_back(study(loaded.scene, options, session.progress()));
  complete(studies[0].report, loaded, session);
  return studies;
}

int run(const Arguments& arguments, Session& session) {
  const bool paper = arguments.given("paper");
  if (paper == arguments.given("scene"))
    throw Error(Code::usage, "SCENE", paper ? "--paper brings scenes of its own" : "is missing",
                "a scene, or --paper; see aktina study --help");
  const Path folder = arguments.text("output");
  check_study_folder(folder);
  std::vector<Study> studies = study_of(arguments, session);
  Stopwatch watch;
  for (const Path& file : write_study(folder, studies)) session.wrote(file);
  Report& report = studies.back().report;
  report.time("write", watch.lap());
  std::string text;
  for (const Study& study : studies) text += summary(study);
  return session.finish(report, session.quiet() ? "" : text);
}

constexpr Option kInputs[] = {
    {.name = "scene", .help = "glTF (.gltf, .glb), OBJ, PLY, STL or OFF", .kind = Kind::file, .value = "SCENE"},
};
constexpr Option kStudyOptions[] = {
    {.name = "output",
     .help = "folder for report.html, report.json and report.csv; new, empty, or that of an earlier study",
     .kind = Kind::file,
     .value = "FOLDER",
     .letter = 'o',
     .required = true,
     .affects_result = false},
    {.name = "family",
     .help = "whose methods are compared",
     .kind = Kind::choice,
     .value = "FAMILY",
     .fallback = "shading",
     .choices = kStudyFamilies},
    {.name = "paper", .help = "the classic comparison, on a sphere, a torus, a bent strip and a teapot; no SCENE"},
    {.name = "methods",
     .help = "only these, separated by commas, with parameters after a colon (default all of the family)",
     .kind = Kind::text,
     .value = "LIST"},
    {.name = "reference",
     .help = "what the methods are held against: one of the family, or an integrator as path (default per-pixel Phong; "
             "of normals those of the file; where light is traced, path with sixteen times the samples)",
     .kind = Kind::text,
     .value = "METHOD"},
    {.name = "illumination",
     .help = "how a surface reflects, where the family is rasterized",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "phong",
     .family = "illumination"},
    {.name = "size",
     .help = "of the pictures in pixels; 480x: the height follows from the camera (default 480x)",
     .kind = Kind::text,
     .value = "WxH"},
    {.name = "samples",
     .help = "per pixel of the pictures that are compared; 1, 4 or 16 where the family is rasterized",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "16",
     .letter = 's',
     .min = 1,
     .max = 65536},
    {.name = "rounds",
     .help = "of timing; the least time counts",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "7",
     .min = 1,
     .max = 1000},
    {.name = "no-growth", .help = "leave out the sweeps over finer meshes and larger pictures"},
    {.name = "camera", .help = "by name, or by number from 0 (default the first)", .kind = Kind::text, .value = "NAME"},
    kSeed,
    kUnits,
    kNormals,
    kCrease,
    kEnvironment,
    kEnvironmentScale,
    kEnvironmentRotation,
};
constexpr Example kExamples[] = {
    {"every shading method on a model", "aktina study teapot.obj -o report/"},
    {"three of them, quickly", "aktina study room.glb -o report/ --methods gouraud,quadratic,phong --no-growth"},
    {"how a surface reflects, against Cook and Torrance's model",
     "aktina study room.glb -o report/ --family illumination --reference cook_torrance"},
    {"the classic comparison", "aktina study --paper -o report/"},
    {"ray tracers against a path traced picture", "aktina study room.glb -o report/ --family integrator --size 240x"},
};

}  // namespace

extern constinit const Command study_command = {
    "study",
    "compare the methods of a family: how good each is, and what it costs",
    "Draws one view by each method of a family, and reports how far each picture is from a reference (RMSE, FLIP, "
    "highlights, polygon edges, flicker), what it costs (time a pixel and a triangle, evaluations, operations), how "
    "both "
    "grow, and whether what papers claim holds here. report.html needs nothing else and works offline. Times depend on "
    "the machine; everything else is the same again. Ctrl-C stops and writes what is known then.",
    kInputs,
    kStudyOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
