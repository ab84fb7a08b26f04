// aktina radiosity: the light on the surfaces of a scene, as numbers.
#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/radiosity/error_estimate.h"
#include "aktina/render/job.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

constexpr std::string_view kFormats[] = {"aktina", "vtu", "csv", "glb", "gltf"};

/// What an engineer wants to see at once.
std::string summary(const Solution& s) {
  double area = 0, lumens = 0, brightest = 0;
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    const double e = double(luminance(s.irradiances[i].v)), a = double(s.mesh.areas[i]);
    area += a, lumens += e * a;
    brightest = std::max(brightest, e);
  }
  return fmt::format(
      "{} patches, {:.4g} m^2; illuminance {:.4g} lx on average, {:.4g} lx at most; "
      "about {:.2g} % off within patches\n"
      "emitted {:.4g} lm, absorbed {:.4g} lm, escaped {:.4g} lm; {} after {} steps, {:.2g} of the light unshot\n",
      s.mesh.size(), area, area > 0 ? lumens / area : 0, brightest, 100 * relative_error(s), s.emitted, s.absorbed,
      s.escaped, s.converged ? "converged" : "not converged", s.steps, s.unshot);
}

int run(const Arguments& arguments, Session& session) {
  RadiosityOptions options = radiosity_options(arguments);
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);
  options.checkpoint = checkpoint_options(arguments, session);
  const LoadedScene loaded = load(arguments, session);
  session.begin_work();
  Radiosities result = solve(loaded.scene, options, session.progress());
  complete(result.report, loaded, session);
  Stopwatch watch;
  for (const Path& output : outputs) {
    write_radiosities(output, loaded.scene, result);
    session.wrote(output);
  }
  result.report.time("write", watch.lap());
  const int status = result.solution.converged ? 0 : info(Code::check_failed).exit_status;
  return session.finish(result.report, session.quiet() ? "" : summary(result.solution), "", status);
}

constexpr Option kOutputs[] = {
    result_files(
        "the solution: .aktina (all of it), .vtu (ParaView), .csv (a line a patch), .glb or .gltf (lit model); "
        "may be given again"),
};
constexpr auto kOptions = joined(joined(kOutputs, kRadiosityOptions), kCheckpointOptions);
constexpr Example kExamples[] = {
    {"lux on every patch, for ParaView and for a spreadsheet", "aktina radiosity room.glb -o room.vtu -o room.csv"},
    {"patches of at most 10 cm, closer to balance",
     "aktina radiosity room.glb -o room.vtu --patch-size 0.1 --tolerance 1e-4"},
    {"a long run that may be killed: the same line again goes on",
     "aktina radiosity room.glb -o room.aktina --quality fine --checkpoint room.checkpoint --every 5min --resume"},
};

}  // namespace

extern constinit const Command radiosity_command = {
    "radiosity",
    "compute the light on the surfaces of a scene",
    "Cuts the surfaces into patches and balances the light between them: all surfaces are taken as diffuse. Writes "
    "illuminance (lx) and exitance (lm/m^2) of each patch. Ctrl-C stops and writes the solution as far as it is. Exit "
    "status 5 if it did not converge within --max-steps.",
    kSceneInput,
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
