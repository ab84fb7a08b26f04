// aktina bake: a scene -> the same scene with its light in it, for viewers that compute none.
#include <fmt/core.h>

#include "aktina/export/export.h"
#include "aktina/render/job.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

constexpr std::string_view kFormats[] = {"glb", "gltf"};

int run(const Arguments& arguments, Session& session) {
  const RadiosityOptions options = radiosity_options(arguments);
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);
  const LoadedScene loaded = load(arguments, session);
  session.begin_work();
  Radiosities result = solve(loaded.scene, options, session.progress());
  complete(result.report, loaded, session);

  Stopwatch watch;
  LitGltfOptions lit{.exposure = float(arguments.number("exposure")), .metadata = provenance(result.report)};
  if (lit.exposure == 0) lit.exposure = lit_exposure(result.solution);
  for (const Path& output : outputs) {
    write_lit_gltf(output, loaded.scene, result.solution, lit);
    session.wrote(output);
  }
  result.report.time("write", watch.lap());
  result.report.count("exposure", double(lit.exposure), "1/(cd/m^2)");
  return session.finish(result.report, "");
}

constexpr Option kBakeOptions[] = {
    result_files("the lit model: .glb, or .gltf with a .bin beside it; may be given again"),
    {.name = "exposure",
     .help =
         "factor from radiance in cd/m^2 to vertex colours; 0: the largest at which no more than 1 % of the area clips",
     .kind = Kind::number,
     .value = "X",
     .fallback = "0",
     .min = 0,
     .max = 1e9},
};
constexpr auto kOptions = joined(kBakeOptions, kRadiosityOptions);
constexpr Example kExamples[] = {
    {"global illumination that costs nothing at run time", "aktina bake room.glb -o room.lit.glb"},
    {"finer shadows", "aktina bake room.glb -o room.lit.glb --patch-size 0.05"},
};

}  // namespace

extern constinit const Command bake_command = {
    "bake",
    "write a scene with its light in vertex colours",
    "Computes the light between all surfaces by radiosity and writes it into the vertex colours of a glTF file with "
    "unlit materials: any viewer shows it, without computing light. Textures, names, hierarchy, cameras, lights and "
    "the "
    "original materials are kept. docs/baking.md tells more.",
    kSceneInput,
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
