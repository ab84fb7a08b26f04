// aktina viewfactors: how much of the light or heat leaving each surface arrives at each other one.
#include <fmt/format.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/render/view_factor_job.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

constexpr std::string_view kFormats[] = {"npz", "h5", "hdf5", "csv", "vtu", "txt"};
constexpr std::string_view kBy[] = {"face", "object", "material"};

SurfacesBy surfaces_by(const std::string& word) {
  return word == "face" ? SurfacesBy::face : word == "object" ? SurfacesBy::object : SurfacesBy::material;
}

/// The certificate in words.
std::string summary(const ViewFactorResult& result) {
  const Certificate& c = result.certificate;
  const ViewFactors& f = result.factors;
  std::string text = fmt::format(
      "{} surfaces, {} view factors above 0\n"
      "closure: rows sum to {:.6f} .. {:.6f}, {}\n"
      "reciprocity: largest difference {:.2g}\n"
      "bounds: {:.3g} .. {:.6g}, {} outside 0 .. 1\n"
      "obstruction: {} pairs came out above their unobstructed value, by {:.2g} at most\n"
      "error: {:.2g} at most by estimate, from {} to {}\n",
      f.size(), f.factors.size(), c.least_sum, c.most_sum,
      c.closed ? "a closed enclosure" : "not a closed enclosure (what is missing to 1 leaves it)", c.worst_reciprocity,
      c.least, c.most, c.out_of_bounds, c.held, c.largest_excess, c.largest_error, f.names[c.largest_error_row],
      f.names[c.largest_error_column]);
  text += c.closed ? "rows farthest from 1:\n" : "rows with the largest errors:\n";
  for (const Certificate::Row& row : c.worst)
    text += fmt::format("  {}: sum {:.6f}, error {:.2g}\n", f.names[row.surface], row.sum, row.error);
  if (result.repaired) text += fmt::format("repaired: factors were changed by {:.2g} at most\n", result.largest_repair);
  if (result.balanced)
    text += fmt::format("grey bodies: {:.6g} W leave the surfaces on the whole\n", result.balance.net);
  return text;
}

ViewFactorJob job_of(const Arguments& arguments, const ViewFactorScene& scene) {
  ViewFactorJob job;
  job.options.target_error = arguments.number("target-error");
  job.options.most_bytes = uint64_t(arguments.number("max-memory") * 1e9);
  job.options.scratch = arguments.text("scratch");
  job.repair = arguments.given("repair");
  job.gray_body = arguments.given("gray-body");
  for (const char* option : {"surfaces", "emissivity", "surroundings"})
    if (!job.gray_body && arguments.given(option))
      throw Error(Code::usage, fmt::format("--{}", option), "has no effect without --gray-body");
  job.surroundings = arguments.number("surroundings");
  if (!job.gray_body) return job;
  job.bodies = gray_bodies(scene, arguments.number("emissivity"));
  if (const std::string& table = arguments.text("surfaces"); !table.empty())
    job.bodies = read_gray_bodies(table, scene, std::move(job.bodies));
  return job;
}

int run(const Arguments& arguments, Session& session) {
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);
  Stopwatch watch;
  const ViewFactorScene scene =
      load_view_factor_scene(arguments.text("model"), surfaces_by(arguments.text("by")),
                             arguments.given("two-sided") ? Backs::see : Backs::hide,
                             arguments.given("clear") ? Clear::pass : Clear::hide, arguments.number("units"));
  const double load_seconds = watch.lap();
  session.show_warnings(scene.warnings);
  ViewFactorJob job = job_of(arguments, scene);
  job.options.foreseen = [&](double bytes) {
    session.note(fmt::format("the matrix will take about {:.2g} GB of {}", bytes / 1e9, arguments.text("scratch")));
  };
  session.begin_work();
  ViewFactorResult result = view_factors(scene, job, session.progress());
  result.report.settings = session.settings();
  result.report.timings.insert(result.report.timings.begin(), {"load", load_seconds});
  watch.lap();
  for (const Path& output : outputs) {
    write_view_factors(output, scene, result);
    session.wrote(output);
  }
  result.report.time("write", watch.lap());
  Warnings own;  // the scene's have been shown
  const auto& shown = scene.warnings.items();
  for (const Warnings::Item& item : result.report.warnings.items())
    if (std::none_of(shown.begin(), shown.end(), [&](const auto& other) { return other.text == item.text; }))
      own.add(item.text, item.count);
  session.show_warnings(own);
  const bool met = result.certificate.largest_error <= job.options.target_error;
  if (!met)
    session.note(fmt::format("the estimated error of {:.2g} is above the target", result.certificate.largest_error));
  const int status = met ? 0 : info(Code::check_failed).exit_status;
  return session.finish(result.report, session.quiet() ? "" : summary(result), certificate_json(result), status);
}

constexpr Option kModel[] = {
    {.name = "model",
     .help = "glTF (.gltf, .glb), OBJ, PLY, STL, OFF or View3D (.vs3)",
     .kind = Kind::file,
     .value = "MODEL",
     .required = true},
};
constexpr Option kOptions[] = {
    result_files(
        "the matrix: .npz (NumPy, SciPy), .h5 (HDF5), .csv, .vtu (ParaView), .txt (View3D's format); may be given "
        "again"),
    {.name = "target-error",
     .help = "wanted absolute error of each view factor",
     .kind = Kind::number,
     .value = "E",
     .fallback = "1e-4",
     .min = 1e-8,
     .max = 0.1},
    {.name = "by",
     .help = "what is one surface: each polygon of the file, each object, all of one material",
     .kind = Kind::choice,
     .value = "WHAT",
     .fallback = "face",
     .choices = kBy},
    {.name = "two-sided", .help = "backs of two-sided materials take part, too"},
    {.name = "clear", .help = "light goes straight on through glass and what alpha leaves open; else they hide all"},
    {.name = "repair", .help = "make the rows of a closed enclosure sum to 1, keeping reciprocity"},
    {.name = "gray-body", .help = "exchange of heat between grey surfaces: Gebhart factors, script-F and balance"},
    {.name = "emissivity",
     .help = "of surfaces that nothing else states one for",
     .kind = Kind::number,
     .value = "E",
     .fallback = "0.9",
     .min = 1e-6,
     .max = 1},
    {.name = "surfaces",
     .help = "CSV of grey surfaces: surface,emissivity,temperature_K,flux_W_m2; empty where unknown",
     .kind = Kind::file,
     .value = "FILE"},
    {.name = "surroundings",
     .help = "temperature in K of what openings see",
     .kind = Kind::number,
     .value = "K",
     .fallback = "0",
     .min = 0,
     .max = 1e6},
    {.name = "max-memory",
     .help = "GB that the matrix may take; more is refused before it starts, or goes into --scratch; 0: three quarters "
             "of the machine's",
     .kind = Kind::number,
     .value = "GB",
     .fallback = "0",
     .min = 0,
     .max = 1e6,
     .affects_result = false},
    {.name = "scratch",
     .help = "a folder for files that hold a matrix too large for memory while it is computed; without it such a "
             "matrix is refused",
     .kind = Kind::file,
     .value = "FOLDER",
     .affects_result = false},
    kUnits,
};
constexpr Example kExamples[] = {
    {"the matrix as NumPy arrays, and for ParaView", "aktina viewfactors room.obj -o F.npz -o F.vtu"},
    {"between objects, to 1e-6", "aktina viewfactors room.glb --by object --target-error 1e-6 -o F.csv"},
    {"heat between grey surfaces of known temperature",
     "aktina viewfactors oven.vs3 --gray-body --surfaces oven.csv -o F.h5"},
};

}  // namespace

extern constinit const Command viewfactors_command = {
    "viewfactors",
    "compute view factors between surfaces, with a certificate",
    "Computes the N x N matrix of view (form) factors between the fronts of the surfaces of a model, which hide each "
    "other, and certifies it: closure, reciprocity, bounds, an estimate of each entry's error. Nothing is normalised "
    "unless --repair asks for it. Exit status 5 if an error is estimated above the target. docs/view-factors.md tells "
    "more.",
    kModel,
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
