#include "scene_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "aktina/base/error.h"
#include "aktina/import/import.h"

namespace aktina::app {

LoadedScene load(const Arguments& arguments, const Session& session) {
  Stopwatch watch;
  LoadedScene loaded;
  const std::string& normals = arguments.text("normals");
  loaded.scene = load_scene(arguments.text("scene"),
                            {.metres_per_unit = arguments.number("units"),
                             .normals = normals == "file" ? "" : normals,
                             .crease = float(arguments.number("crease") * kPi / 180),
                             .environment = arguments.text("environment"),
                             .environment_scale = arguments.number("environment-scale"),
                             .environment_rotation = arguments.number("environment-rotation") * kPi / 180});
  loaded.seconds = watch.lap();
  session.show_warnings(loaded.scene.warnings);
  return loaded;
}

RadiosityOptions radiosity_options(const Arguments& arguments, const Scene& scene) {
  RadiosityOptions options;
  options.solver = arguments.text("solver");
  options.formfactor = arguments.text("formfactor");
  options.mesher = arguments.text("mesher");
  options.quality = arguments.text("quality");
  options.target_error = arguments.number("target-error");
  options.indirect_size = arguments.number("indirect-size");
  options.patch_size = arguments.number("patch-size");
  options.tolerance = arguments.number("tolerance");
  options.most_steps = uint64_t(arguments.whole("max-steps"));
  options.seed = uint32_t(arguments.whole("seed"));
  if (const std::string& camera = arguments.text("importance"); !camera.empty()) {
    options.importance = scene.cameras[size_t(find_camera(scene, camera, "--importance"))];
    options.importance->name = camera;
  }
  return options;
}

namespace {

/// Seconds of "90s", "5min", "1h".
double read_duration(const std::string& text) {
  constexpr std::pair<std::string_view, double> kUnits[] = {{"s", 1}, {"min", 60}, {"h", 3600}};
  double value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  for (const auto& [unit, seconds] : kUnits)
    if (parsed.ec == std::errc() && std::string_view(parsed.ptr, end) == unit && value >= 0 && value <= 1e6)
      return value * seconds;
  throw Error(Code::usage, "--every", fmt::format("'{}' is no time", text), "as 30s, 5min, 1h");
}

}  // namespace

CheckpointOptions checkpoint_options(const Arguments& arguments, Session& session) {
  CheckpointOptions options;
  options.file = arguments.text("checkpoint");
  options.seconds = read_duration(arguments.text("every"));
  options.resume = arguments.given("resume");
  if (options.file.empty()) {
    if (options.resume) throw Error(Code::usage, "--resume", "from which file?", "--checkpoint FILE");
    return options;
  }
  session.will_write(options.file);
  if (options.resume && !std::filesystem::exists(options.file))
    session.note(fmt::format("{} is not there yet: from the beginning", display(options.file)));
  return options;
}

void read_size(const std::string& text, int& width, int& height) {
  const auto number = [&](std::string_view part) {
    int value = 0;
    const auto parsed = std::from_chars(part.data(), part.data() + part.size(), value);
    if (parsed.ec == std::errc::result_out_of_range) throw Error(Code::limit, "--size", fmt::format("got {}", text));
    if (parsed.ec != std::errc() || parsed.ptr != part.data() + part.size() || value < 1)
      throw Error(Code::usage, "--size", fmt::format("'{}' is not a size", text), "WIDTHxHEIGHT, as 960x640");
    return value;
  };
  if (text.empty()) return;
  const std::string_view all = text;
  const size_t cross = all.find('x');
  const std::string_view wide = all.substr(0, cross), high = cross == all.npos ? "" : all.substr(cross + 1);
  if (cross == all.npos || (wide.empty() && high.empty())) number("");
  if (!wide.empty()) width = number(wide);
  if (!high.empty()) height = number(high);
}

int find_camera(const Scene& scene, const std::string& wanted, std::string_view option) {
  if (wanted.empty()) return 0;
  std::vector<std::string_view> names;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == wanted) return int(names.size());
    names.push_back(camera.name);
  }
  int index = -1;
  const auto parsed = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (parsed.ec == std::errc() && parsed.ptr == wanted.data() + wanted.size() && index >= 0 &&
      size_t(index) < names.size())
    return index;
  throw Error(Code::usage, std::string(option), fmt::format("the scene has no camera '{}'", wanted),
              fmt::format("it has: {} (or by number, from 0)", fmt::join(names, ", ")));
}

std::vector<Path> checked_outputs(const Arguments& arguments, Session& session,
                                  std::span<const std::string_view> extensions) {
  std::vector<Path> outputs;
  for (const std::string& text : arguments.all("output")) {
    const std::string extension = lower_extension(text);
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
      throw Error(Code::usage, text, "cannot tell the format from the name",
                  fmt::format("one of .{}", fmt::join(extensions, ", .")));
    outputs.emplace_back(text);
  }
  for (const Path& output : outputs) session.will_write(output);
  return outputs;
}

void complete(Report& report, const LoadedScene& loaded, const Session& session) {
  report.settings = session.settings();
  report.timings.insert(report.timings.begin(), {"load", loaded.seconds});
  const auto& known = loaded.scene.warnings.items();
  Warnings fresh;
  for (const Warnings::Item& item : report.warnings.items())
    if (std::none_of(known.begin(), known.end(), [&](const Warnings::Item& k) { return k.text == item.text; }))
      fresh.add(item.text, item.count);
  session.show_warnings(fresh);
}

}  // namespace aktina::app
