// aktina bake: a scene -> the same scene with its light in it, for viewers that compute none.
#include "aktina/render/bake_job.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

constexpr std::string_view kFormats[] = {"glb", "gltf", "exr"};
constexpr std::string_view kForms[] = {"vertex", "emissive", "lightmap"};

LightmapOptions lightmap_options(const Arguments& arguments) {
  LightmapOptions options;
  options.texel_size = arguments.number("texel-size");
  options.size = int(arguments.whole("lightmap-size"));
  options.padding = int(arguments.whole("padding"));
  options.keep_uv = arguments.text("uv") == "keep";
  options.direct_samples = int(arguments.whole("direct-samples"));
  options.gather_samples = int(arguments.whole("gather-samples"));
  options.seed = uint32_t(arguments.whole("seed"));
  return options;
}

int run(const Arguments& arguments, Session& session) {
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);
  for (const Path& output : outputs)
    if (const Path beside = Baking::beside(output, arguments.text("as")); !beside.empty()) session.will_write(beside);
  const CheckpointOptions checkpoint = checkpoint_options(arguments, session);
  const LoadedScene loaded = load(arguments, session);
  RadiosityOptions options = radiosity_options(arguments, loaded.scene);
  options.checkpoint = checkpoint;
  session.begin_work();
  Radiosities result = solve(loaded.scene, options, session.progress());
  Report& report = result.report;
  report.settings = session.settings();
  Baking baking(loaded.scene, result, arguments.text("as"), float(arguments.number("exposure")),
                lightmap_options(arguments));
  Stopwatch watch;
  for (const Path& output : outputs)
    for (const Path& file : baking.write(output, session.progress())) session.wrote(file);
  report.time("write", watch.lap());
  complete(report, loaded, session);
  return session.finish(report, "");
}

constexpr std::string_view kUvs[] = {"keep", "make"};
constexpr Option kBakeOptions[] = {
    result_files("the lit model: .glb, or .gltf with a .bin beside it; .exr: its lightmap in lux; may be given again"),
    {.name = "as",
     .help =
         "what carries the light: colours of vertices, a texture on black materials that shine, or a lightmap on the "
         "materials as they are",
     .kind = Kind::choice,
     .value = "FORM",
     .fallback = "vertex",
     .choices = kForms},
    {.name = "exposure",
     .help = "factor from radiance in cd/m^2 to colours; 0: the largest at which no more than 1 % of the area clips",
     .kind = Kind::number,
     .value = "X",
     .fallback = "0",
     .min = 0,
     .max = 1e9},
    {.name = "texel-size",
     .help = "of lightmaps, in metres; 0: the smallest at which all fits on one page",
     .kind = Kind::number,
     .value = "METRES",
     .fallback = "0",
     .min = 0,
     .max = 1e6},
    {.name = "lightmap-size",
     .help = "largest width and height of a lightmap's page, in texels",
     .kind = Kind::whole,
     .value = "TEXELS",
     .fallback = "1024",
     .min = 8,
     .max = 16384},
    {.name = "padding",
     .help = "texels about each chart that are nobody else's",
     .kind = Kind::whole,
     .value = "TEXELS",
     .fallback = "2",
     .min = 0,
     .max = 64},
    {.name = "uv",
     .help = "second texture coordinates of the file: keep those that can be used, or make all anew",
     .kind = Kind::choice,
     .value = "WHAT",
     .fallback = "keep",
     .choices = kUvs},
    {.name = "direct-samples",
     .help = "shadow rays a texel for sharp shadows; 0: direct light as the patches have it",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "16",
     .min = 0,
     .max = 65536},
    {.name = "gather-samples",
     .help = "rays a texel that gather indirect light; 0: as the patches have it",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "0",
     .min = 0,
     .max = 65536},
};
constexpr auto kOptions = joined(joined(kBakeOptions, kRadiosityOptions), kCheckpointOptions);
constexpr Example kExamples[] = {
    {"global illumination that costs nothing at run time", "aktina bake room.glb -o room.lit.glb"},
    {"finer shadows", "aktina bake room.glb -o room.lit.glb --patch-size 0.05"},
    {"sharp shadows in a texture, 1 cm a texel",
     "aktina bake room.glb -o room.lit.glb --as emissive --texel-size 0.01"},
    {"the lightmap alone, in lux", "aktina bake room.glb -o room.exr"},
};

}  // namespace

extern constinit const Command bake_command = {
    "bake",
    "write a scene with its light in it, for viewers that compute none",
    "Computes the light between all surfaces by radiosity and writes it into a glTF file: as vertex colours on unlit "
    "materials or as a texture on black ones that shine, which any viewer shows without computing light, or as a "
    "lightmap on the materials as they are, for viewers that know MOZ_lightmap. Names, hierarchy, cameras, lights and "
    "the original materials are kept. docs/baking.md tells more.",
    kSceneInput,
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
