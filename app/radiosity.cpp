// aktina radiosity: the light on the surfaces of a scene, as numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

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

/// What the text says about a light: NAME=FACTOR.
struct Dimmed {
  std::string light;
  double factor;
};

Dimmed read_dimmed(const std::string& text) {
  const size_t equals = text.rfind('=');
  Dimmed dimmed{text.substr(0, equals), 0};
  const char* const end = text.data() + text.size();
  const char* const number = equals == text.npos ? end : text.data() + equals + 1;
  const auto parsed = std::from_chars(number, end, dimmed.factor);
  if (parsed.ec != std::errc() || parsed.ptr != end || !(dimmed.factor >= 0 && dimmed.factor <= 1e9))
    throw Error(Code::usage, "--dim", fmt::format("'{}' is no light with a factor", text),
                "NAME=FACTOR, the factor 0 .. 1e9");
  return dimmed;
}

/// One for each light. @throws Error usage (no such light)
std::vector<double> factors_of(const std::vector<std::string>& names, const std::vector<std::string>& texts) {
  std::vector<double> factors(names.size(), 1);
  for (const std::string& text : texts) {
    const Dimmed dimmed = read_dimmed(text);
    const auto found = std::find(names.begin(), names.end(), dimmed.light);
    if (found == names.end())
      throw Error(Code::usage, "--dim", fmt::format("the scene has no light '{}'", dimmed.light),
                  fmt::format("it has: {}", fmt::join(names, ", ")));
    factors[size_t(found - names.begin())] = dimmed.factor;
  }
  return factors;
}

/// room.vtu -> room.desk_lamp.vtu
Path with_light(const Path& output, const std::string& light, size_t number) {
  std::string safe;
  for (const char c : light) safe += std::isalnum(static_cast<unsigned char>(c)) || c == '-' || (c & 0x80) ? c : '_';
  Path path = output;
  const std::string extension = output.extension().string();
  return path.replace_extension(fmt::format("{}.{}{}", number, safe, extension));
}

/// Each light into files of its own.
int run_each_light(const LoadedScene& loaded, const RadiosityOptions& options, const std::vector<Path>& outputs,
                   Session& session) {
  std::vector<LightRadiosities> lights = solve_lights(loaded.scene, options, session.progress());
  Report report = lights[0].result.report;
  report.counts.clear();
  std::string text;
  for (size_t k = 0; k < lights.size(); ++k) {
    Radiosities& result = lights[k].result;
    complete(result.report, loaded, session);
    for (const Path& output : outputs) {
      const Path own = with_light(output, lights[k].light, k);
      write_radiosities(own, loaded.scene, result);
      session.wrote(own);
    }
    text += fmt::format("{}: {}", lights[k].light, summary(result.solution));
    report.count(lights[k].light, result.solution.emitted, "lm");
    report.complete = report.complete && result.report.complete;
  }
  complete(report, loaded, session);
  return session.finish(report, session.quiet() ? "" : text);
}

int run(const Arguments& arguments, Session& session) {
  for (const std::string& text : arguments.all("dim")) read_dimmed(text);
  if (arguments.given("dim") && arguments.given("each-light"))
    throw Error(Code::usage, "--each-light", "and --dim exclude each other");
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);
  const CheckpointOptions checkpoint = checkpoint_options(arguments, session);
  const LoadedScene loaded = load(arguments, session);
  RadiosityOptions options = radiosity_options(arguments, loaded.scene);
  options.checkpoint = checkpoint;
  const std::vector<double> factors = factors_of(light_names(loaded.scene), arguments.all("dim"));
  session.begin_work();
  if (arguments.given("each-light")) return run_each_light(loaded, options, outputs, session);
  Radiosities result;
  if (arguments.given("dim")) {
    const std::vector<LightRadiosities> lights = solve_lights(loaded.scene, options, session.progress());
    std::vector<DimmedLight> dimmed;
    for (size_t k = 0; k < lights.size(); ++k) dimmed.push_back({lights[k].light, &lights[k].result, factors[k]});
    result = mix(dimmed);
  } else {
    result = solve(loaded.scene, options, session.progress());
  }
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
    {.name = "each-light",
     .help = "each lamp, each object that shines and the sky by itself: room.vtu becomes room.0.NAME.vtu, ..."},
    {.name = "dim",
     .help = "that light's flux times a factor, the others' as it is; may be given again",
     .kind = Kind::text,
     .value = "NAME=FACTOR",
     .several = true},
};
constexpr auto kOptions = joined(joined(kOutputs, kRadiosityOptions), kCheckpointOptions);
constexpr Example kExamples[] = {
    {"lux on every patch, for ParaView and for a spreadsheet", "aktina radiosity room.glb -o room.vtu -o room.csv"},
    {"patches of at most 10 cm, closer to balance",
     "aktina radiosity room.glb -o room.vtu --patch-size 0.1 --tolerance 1e-4"},
    {"how much each lamp contributes", "aktina radiosity room.glb -o room.vtu --each-light"},
    {"the same room with one lamp dimmed and another off",
     "aktina radiosity room.glb -o room.glb --dim ceiling=0.5 --dim desk=0"},
    {"the light that one picture needs, and no more",
     "aktina radiosity house.glb -o house.aktina --solver hierarchical --importance kitchen"},
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
