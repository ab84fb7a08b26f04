// Options and steps that the commands which read a scene share.
#pragma once

#include <array>

#include "aktina/radiosity/solve.h"
#include "aktina/scene/scene.h"
#include "session.h"

namespace aktina::app {

inline constexpr Option kSceneInput[] = {
    {.name = "scene",
     .help = "glTF (.gltf, .glb), OBJ, PLY, STL, OFF, FBX, COLLADA (.dae) or 3DS",
     .kind = Kind::file,
     .value = "SCENE",
     .required = true},
};

/// -o FILE, as often as there are formats to write.
constexpr Option result_files(std::string_view help, bool required = true) {
  return {.name = "output",
          .help = help,
          .kind = Kind::file,
          .value = "FILE",
          .letter = 'o',
          .required = required,
          .several = true,
          .affects_result = false};
}

inline constexpr Option kUnits = {.name = "units",
                                  .help = "metres that one unit of the file stands for; 0: as its format says",
                                  .kind = Kind::number,
                                  .value = "METRES",
                                  .fallback = "0",
                                  .min = 0,
                                  .max = 1e6};

inline constexpr std::string_view kNormalsOfFile[] = {"file"};
inline constexpr Option kNormals = {.name = "normals",
                                    .help = "vertex normals made anew from the facets; file: those that it has",
                                    .kind = Kind::method,
                                    .value = "METHOD",
                                    .fallback = "file",
                                    .choices = kNormalsOfFile,
                                    .family = "normals"};
inline constexpr Option kCrease = {.name = "crease",
                                   .help = "edges sharper than this stay sharp where normals are made, in degrees",
                                   .kind = Kind::number,
                                   .value = "DEGREES",
                                   .fallback = "30",
                                   .min = 0,
                                   .max = 180};

inline constexpr Option kEnvironment = {.name = "environment",
                                        .help =
                                            "a picture of the surroundings, equirectangular, that shines on the "
                                            "scene in place of its own: .hdr, .exr, .png, .jpg, .webp",
                                        .kind = Kind::file,
                                        .value = "FILE"};
inline constexpr Option kEnvironmentScale = {.name = "environment-scale",
                                             .help = "from its values to cd/m^2",
                                             .kind = Kind::number,
                                             .value = "X",
                                             .fallback = "1",
                                             .min = 0,
                                             .max = 1e9};
inline constexpr Option kEnvironmentRotation = {.name = "environment-rotation",
                                                .help = "about the vertical, in degrees",
                                                .kind = Kind::number,
                                                .value = "DEGREES",
                                                .fallback = "0",
                                                .min = -360,
                                                .max = 360};

inline constexpr Option kSeed = {.name = "seed",
                                 .help = "of the random numbers",
                                 .kind = Kind::whole,
                                 .value = "N",
                                 .fallback = "0",
                                 .min = 0,
                                 .max = 4294967295.0};

inline constexpr std::string_view kQualities[] = {"draft", "normal", "fine"};

/// How a radiosity solution is computed: `render`, `radiosity` and `bake` take these.
inline constexpr Option kRadiosityOptions[] = {
    {.name = "solver",
     .help = "how the light between surfaces is balanced",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "stochastic_jacobi",
     .family = "radiosity"},
    {.name = "quality",
     .help = "draft, normal or fine: patches, tolerance and error where they are not given",
     .kind = Kind::choice,
     .value = "QUALITY",
     .fallback = "normal",
     .choices = kQualities},
    {.name = "formfactor",
     .help = "how much of a patch's light reaches another",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "ray_cast",
     .family = "formfactor"},
    {.name = "mesher",
     .help = "how surfaces are cut into patches",
     .kind = Kind::method,
     .value = "METHOD",
     .fallback = "uniform",
     .family = "mesher"},
    {.name = "patch-size",
     .help = "longest edge of a patch in metres; 0: by quality and the size of the scene",
     .kind = Kind::number,
     .value = "METRES",
     .fallback = "0",
     .min = 0,
     .max = 1e6},
    {.name = "tolerance",
     .help = "stop when less than this share of the light is not distributed yet; 0: by quality",
     .kind = Kind::number,
     .value = "SHARE",
     .fallback = "0",
     .min = 0,
     .max = 1},
    {.name = "target-error",
     .help = "of the light on surfaces, relative, where a solver draws samples; 0: by quality",
     .kind = Kind::number,
     .value = "SHARE",
     .fallback = "0",
     .min = 0,
     .max = 1},
    {.name = "indirect-size",
     .help = "longest edge of what exchanges indirect light, in patch sizes; 0: all light on all patches",
     .kind = Kind::number,
     .value = "SIZES",
     .fallback = "2",
     .min = 0,
     .max = 64},
    {.name = "importance",
     .help = "name or number of a camera: what it does not show is computed no finer than its picture needs; of "
             "--solver hierarchical, clustering and wavelets",
     .kind = Kind::text,
     .value = "CAMERA"},
    {.name = "max-steps",
     .help = "stop after so many shots or iterations; 0: no limit",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "0",
     .min = 0,
     .max = 1e15},
    kSeed,
    kUnits,
    kNormals,
    kCrease,
    kEnvironment,
    kEnvironmentScale,
    kEnvironmentRotation,
};
/// @throws Error usage (the scene has no such camera)
RadiosityOptions radiosity_options(const Arguments& arguments, const Scene& scene);

/// `radiosity` and `bake`, which may take hours, take these, too.
inline constexpr Option kCheckpointOptions[] = {
    {.name = "checkpoint",
     .help = "keep what is done so far in this file, for --resume",
     .kind = Kind::file,
     .value = "FILE",
     .affects_result = false},
    {.name = "every",
     .help = "time between two writes of the checkpoint: 30s, 5min, 1h",
     .kind = Kind::text,
     .value = "TIME",
     .fallback = "60s",
     .affects_result = false},
    {.name = "resume",
     .help = "go on from the checkpoint of a run that was ended; from the beginning where there is none yet",
     .affects_result = false},
};
/// @throws Error usage, io
CheckpointOptions checkpoint_options(const Arguments& arguments, Session& session);

/// Two tables of options as one.
template <size_t A, size_t B>
constexpr std::array<Option, A + B> joined(const std::array<Option, A>& a, const Option (&b)[B]) {
  std::array<Option, A + B> all{};
  for (size_t i = 0; i < A; ++i) all[i] = a[i];
  for (size_t i = 0; i < B; ++i) all[A + i] = b[i];
  return all;
}
template <size_t A, size_t B>
constexpr std::array<Option, A + B> joined(const Option (&a)[A], const Option (&b)[B]) {
  return joined(std::to_array(a), b);
}

struct LoadedScene {
  Scene scene;
  double seconds;
};

/// Reads the scene and shows what was repaired or added.
LoadedScene load(const Arguments& arguments, const Session& session);

/// "640x480", "640x" (the height follows from the camera) or "x480"; empty: both stay. @throws Error usage, limit
void read_size(const std::string& text, int& width, int& height);

/// By name, or by number from 0; empty: the first. @throws Error usage
/// @param option  that `wanted` was given by
int find_camera(const Scene& scene, const std::string& wanted, std::string_view option = "--camera");

/// The outputs, each checked for a known extension and a place that can be written. @throws Error usage, io
std::vector<Path> checked_outputs(const Arguments& arguments, Session& session,
                                  std::span<const std::string_view> extensions);

/// Completes the report of a job: the command that was given, and the time of loading; shows its warnings.
void complete(Report& report, const LoadedScene& loaded, const Session& session);

}  // namespace aktina::app
