// aktina illuminance: what light meters read at points, on grids and on whole surfaces.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "aktina/base/error.h"
#include "aktina/export/illuminance_files.h"
#include "aktina/render/illuminance_job.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

constexpr std::string_view kFormats[] = {"csv", "vtu", "png"};

/// Nine numbers: corner, side, side.
MeasuringField grid_of(const std::string& text, double spacing) {
  float n[9];
  int end = 0;
  const int read = std::sscanf(text.c_str(), "%f,%f,%f:%f,%f,%f:%f,%f,%f%n", &n[0], &n[1], &n[2], &n[3], &n[4], &n[5],
                               &n[6], &n[7], &n[8], &end);
  bool finite = read == 9 && size_t(end) == text.size();
  for (int k = 0; k < 9 && finite; ++k) finite = std::isfinite(n[k]);
  if (!finite) throw Error(Code::usage, "--grid", fmt::format("'{}' is no grid", text), "X,Y,Z:UX,UY,UZ:VX,VY,VZ");
  return grid({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, spacing);
}

MeasuringField field_of(const Arguments& arguments, const Scene& scene) {
  const double spacing = arguments.number("spacing");
  int asked = 0;
  for (const char* way : {"plane", "grid", "surface", "points"}) asked += arguments.given(way);
  if (asked > 1) throw Error(Code::usage, "illuminance", "more than one of --plane, --grid, --surface, --points");
  if (arguments.given("grid")) return grid_of(arguments.text("grid"), spacing);
  if (arguments.given("surface")) return surface(scene, arguments.text("surface"), spacing);
  if (arguments.given("points")) return read_points(arguments.text("points"));
  const double margin = arguments.given("margin") ? arguments.number("margin") : -1;
  return work_plane(scene, arguments.number("plane"), margin, spacing);
}

std::string summary(const MeasuringField& field, const IlluminanceResult& r) {
  std::string text = fmt::format("{}: {} points", field.name, r.points);
  if (field.is_grid())
    text += fmt::format(" in {} x {} cells of {:.3g} m x {:.3g} m", field.columns, field.rows, length(field.u),
                        length(field.v));
  return text + fmt::format(
                    "\naverage    {:.4g} lx\nminimum    {:.4g} lx\nmaximum    {:.4g} lx\n"
                    "uniformity {:.3f} (minimum / average), {:.3f} (minimum / maximum)\n"
                    "known to   {:.2g} % of the average at each point, {} samples\n",
                    r.average, r.minimum, r.maximum, r.uniformity(), r.diversity(), 100 * r.measurement.error,
                    r.measurement.samples);
}

int run(const Arguments& arguments, Session& session) {
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);
  const LoadedScene loaded = load(arguments, session);
  const MeasuringField field = field_of(arguments, loaded.scene);
  for (const Path& output : outputs)
    if (lower_extension(output) == "png" && !field.is_grid())
      throw Error(Code::usage, display(output), "only grids and work planes have a picture", "write .csv or .vtu");
  MeasureOptions options;
  options.integrator = arguments.text("method");
  options.target_error = arguments.number("target-error");
  options.most_samples = int(arguments.whole("max-samples"));
  options.seed = uint32_t(arguments.whole("seed"));
  session.begin_work();
  IlluminanceResult result = illuminance(loaded.scene, field, options, session.progress());
  complete(result.report, loaded, session);
  Stopwatch watch;
  for (const Path& output : outputs) {
    write_illuminance(output,
                      {field, result.measurement.lux, result.measurement.standard_errors, provenance(result.report)});
    session.wrote(output);
  }
  result.report.time("write", watch.lap());
  const bool short_of = result.report.complete && !result.measurement.reached;
  if (short_of) session.note("the error is above the target: --max-samples was reached");
  return session.finish(result.report, session.quiet() ? "" : summary(field, result), illuminance_json(field, result),
                        short_of ? info(Code::check_failed).exit_status : 0);
}

constexpr Option kOptions[] = {
    result_files("a line a point (.csv), for ParaView (.vtu), false colours of a grid (.png); may be given again",
                 false),
    {.name = "plane",
     .help = "height in metres, above the lowest point, of a horizontal work plane over the whole scene",
     .kind = Kind::number,
     .value = "METRES",
     .fallback = "0.75",
     .min = 0,
     .max = 1e6},
    {.name = "margin",
     .help = "of the work plane, from the sides of the scene, that is left out; EN 12464-1: 0.5 or 15 % of the shorter "
             "side",
     .kind = Kind::number,
     .value = "METRES",
     .min = 0,
     .max = 1e6},
    {.name = "grid",
     .help = "instead: a corner and two sides of a parallelogram in metres; meters face u x v",
     .kind = Kind::text,
     .value = "X,Y,Z:UX,UY,UZ:VX,VY,VZ"},
    {.name = "surface",
     .help = "instead: the front of everything whose node, mesh or material has this name",
     .kind = Kind::text,
     .value = "NAME"},
    {.name = "points",
     .help = "instead: a CSV of x,y,z and a normal (up where there is none)",
     .kind = Kind::file,
     .value = "FILE"},
    {.name = "spacing",
     .help = "largest distance of points in metres; 0: as EN 12464-1 asks",
     .kind = Kind::number,
     .value = "METRES",
     .fallback = "0",
     .min = 0,
     .max = 1e6},
    {.name = "method",
     .help = "how light is followed: direct leaves out what surfaces send on",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "path",
     .letter = 'm',
     .family = "integrator"},
    {.name = "target-error",
     .help = "wanted standard error of the points, as a share of the average",
     .kind = Kind::number,
     .value = "SHARE",
     .fallback = "0.01",
     .min = 1e-6,
     .max = 1},
    {.name = "max-samples",
     .help = "per point, at which to stop at the latest",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "65536",
     .min = 256,
     .max = 16777216},
    kSeed,
    kUnits,
    kNormals,
    kCrease,
    kEnvironment,
    kEnvironmentScale,
    kEnvironmentRotation,
};
constexpr Example kExamples[] = {
    {"average and uniformity on desks, with a plan in false colours",
     "aktina illuminance office.glb --plane 0.75 -o plan.png -o plan.csv"},
    {"a wall of the room, every 10 cm", "aktina illuminance room.glb --surface 'left wall' --spacing 0.1 -o wall.vtu"},
    {"single points to 0.1 %",
     "aktina illuminance room.glb --points meters.csv --target-error 0.001 -o lux.csv --json"},
};

}  // namespace

extern constinit const Command illuminance_command = {
    "illuminance",
    "compute illuminance at points, on grids and on surfaces",
    "Follows light to points and gives illuminance in lux with average, minimum, maximum and uniformity. Without "
    "--grid, --surface or --points it measures a horizontal work plane. Points inside of closed bodies are left out. "
    "Ctrl-C stops and writes what is known. Exit status 5 if the target error was not reached within --max-samples.",
    kSceneInput,
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
