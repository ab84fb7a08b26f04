// aktina render: a scene and a camera -> a picture.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "aktina/base/error.h"
#include "aktina/image/file_format.h"
#include "aktina/render/job.h"
#include "scene_options.h"

namespace aktina::app {
namespace {

constexpr std::string_view kWays[] = {"raster", "radiosity", "two_pass"};
constexpr std::string_view kCurves[] = {"none", "reinhard", "filmic"};
constexpr std::string_view kFormats[] = {"png", "exr", "hdr", "pfm"};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(',', at), text.size());
    if (end > at) parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

float read_exposure(const std::string& text) {
  if (text == "auto") return 0;
  float value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || !(value > 0 && value < kInfinity))
    throw Error(Code::usage, "--exposure", fmt::format("'{}' is neither auto nor a number above 0", text));
  return value;
}

/// "1,0.2"
DepthCue read_depth_cue(const std::string& text) {
  DepthCue cue;
  if (text.empty()) return cue;
  const char *const end = text.data() + text.size(), *const comma = std::find(text.data(), end, ',');
  const auto number = [&](const char* from, const char* to, float& value) {
    const auto parsed = std::from_chars(from, to, value);
    return parsed.ec == std::errc() && parsed.ptr == to;
  };
  if (comma == end || !number(text.data(), comma, cue.k1) || !number(comma + 1, end, cue.k2))
    throw Error(Code::usage, "--depth-cue", fmt::format("'{}' is not two numbers", text), "K1,K2, as 1,0.2");
  check(cue);
  return cue;
}

RenderOptions read_options(const Arguments& arguments) {
  RenderOptions options;
  options.method = arguments.text("method");
  options.shading = arguments.text("shading");
  options.illumination = arguments.text("illumination");
  options.depth_cue = read_depth_cue(arguments.text("depth-cue"));
  options.samples = int(arguments.whole("samples"));
  options.seed = uint32_t(arguments.whole("seed"));
  options.layers = split(arguments.text("layers"));
  read_size(arguments.text("size"), options.width, options.height);
  return options;
}

void write(const std::vector<Path>& outputs, const Rendering& rendering, ToneMapping tone_mapping, Session& session) {
  ImageWriteOptions options{.tone_mapping = tone_mapping, .metadata = provenance(rendering.report)};
  options.metadata.emplace_back("Exposure", fmt::format("{}", tone_mapping.exposure));
  for (const Path& output : outputs) {
    write_image(output, rendering.picture, options);
    session.wrote(output);
  }
}

int run(const Arguments& arguments, Session& session) {
  RenderOptions options = read_options(arguments);
  ToneMapping tone_mapping{.exposure = read_exposure(arguments.text("exposure"))};
  tone_mapping.curve =
      ToneCurve(std::find(std::begin(kCurves), std::end(kCurves), arguments.text("tone")) - std::begin(kCurves));
  const std::vector<Path> outputs = checked_outputs(arguments, session, kFormats);

  const LoadedScene loaded = load(arguments, session);
  options.camera = find_camera(loaded.scene, arguments.text("camera"));
  options.radiosity = radiosity_options(arguments, loaded.scene);
  session.begin_work();
  Rendering rendering = render(loaded.scene, options, session.progress());

  complete(rendering.report, loaded, session);
  Stopwatch watch;
  if (tone_mapping.exposure == 0) tone_mapping.exposure = automatic_exposure(rendering.picture.layers[0].image);
  write(outputs, rendering, tone_mapping, session);
  rendering.report.time("write", watch.lap());
  rendering.report.count("exposure", double(tone_mapping.exposure), "1/(cd/m^2)");
  return session.finish(rendering.report, "");
}

constexpr Option kPictureOptions[] = {
    result_files("the picture: .png (exposed, sRGB), .exr (linear, with layers), .hdr or .pfm; may be given again"),
    {.name = "method",
     .help = "how light is computed; parameters follow a colon, as path:depth=8",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "path",
     .letter = 'm',
     .choices = kWays,
     .family = "integrator"},
    {.name = "shading",
     .help = "of --method raster: what is interpolated across a triangle, as gouraud or phong",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "phong",
     .family = "shading"},
    {.name = "illumination",
     .help = "of --method raster: how a surface reflects",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "phong",
     .family = "illumination"},
    {.name = "depth-cue",
     .help = "of raster and whitted: diffuse and specular light times 1 / (K1 + K2 d), d metres from the eye's plane",
     .kind = Kind::text,
     .value = "K1,K2"},
    {.name = "size",
     .help = "of the picture in pixels; 960x: the height follows from the camera (default 960x)",
     .kind = Kind::text,
     .value = "WxH"},
    {.name = "samples",
     .help = "per pixel; 0: the method's own default",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "0",
     .letter = 's',
     .min = 0,
     .max = 1 << 20},
    {.name = "camera", .help = "by name, or by number from 0 (default the first)", .kind = Kind::text, .value = "NAME"},
    {.name = "exposure",
     .help = "factor on the luminance before it is shown (PNG); auto: from the picture",
     .kind = Kind::text,
     .value = "X",
     .fallback = "auto"},
    {.name = "tone",
     .help = "curve from exposed luminance to the screen (PNG)",
     .kind = Kind::choice,
     .value = "CURVE",
     .fallback = "none",
     .choices = kCurves},
    {.name = "layers",
     .help = "more layers of an .exr, separated by commas: albedo, N (normal), P (position), Z (depth); of "
             "the ray tracers also direct, indirect, illuminance",
     .kind = Kind::text,
     .value = "LIST"},
};
constexpr auto kOptions = joined(kPictureOptions, kRadiosityOptions);
constexpr Example kExamples[] = {
    {"a picture", "aktina render room.glb -o room.png"},
    {"linear, with layers, for compositing",
     "aktina render room.glb -o room.exr --samples 64 --layers albedo,N,direct,indirect"},
    {"radiosity between matt surfaces, rays for mirrors and glass", "aktina render room.glb -o room.png -m two_pass"},
    {"quick, at a given size", "aktina render room.glb -o room.png --method raster --shading gouraud --size 640x480"},
};

}  // namespace

extern constinit const Command render_command = {
    "render",
    "draw a picture of a scene",
    "Draws what a camera of the scene sees. Scenes without a camera are framed, scenes without light get a documented "
    "default light, and the program says so. Ctrl-C stops and writes the picture as far as it is.",
    kSceneInput,
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
