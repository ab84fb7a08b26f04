#include "scene_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "aktina/base/error.h"
#include "aktina/import/import.h"

namespace aktina::app {

LoadedScene load(const Arguments& arguments, const Session& session) {
  Stopwatch watch;
  LoadedScene loaded;
  loaded.scene = load_scene(arguments.text("scene"), {.metres_per_unit = arguments.number("units")});
  loaded.seconds = watch.lap();
  session.show_warnings(loaded.scene.warnings);
  return loaded;
}

RadiosityOptions radiosity_options(const Arguments& arguments) {
  RadiosityOptions options;
  options.solver = arguments.text("solver");
  options.formfactor = arguments.text("formfactor");
  options.mesher = arguments.text("mesher");
  options.patch_size = arguments.number("patch-size");
  options.tolerance = arguments.number("tolerance");
  options.most_steps = uint64_t(arguments.whole("max-steps"));
  options.seed = uint32_t(arguments.whole("seed"));
  return options;
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
