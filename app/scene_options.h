// Options and steps that the commands which read a scene share.
#pragma once

#include <array>

#include "aktina/scene/scene.h"
#include "session.h"

namespace aktina::app {

inline constexpr Option kSceneInput[] = {
    {.name = "scene",
     .help = "glTF (.gltf, .glb), OBJ, PLY, STL, or what else Assimp reads",
     .kind = Kind::file,
     .value = "SCENE",
     .required = true},
};

inline constexpr Option kUnits = {.name = "units",
                                  .help = "metres that one unit of the file stands for; 0: as its format says",
                                  .kind = Kind::number,
                                  .value = "METRES",
                                  .fallback = "0",
                                  .min = 0,
                                  .max = 1e6};

inline constexpr Option kSeed = {.name = "seed",
                                 .help = "of the random numbers",
                                 .kind = Kind::whole,
                                 .value = "N",
                                 .fallback = "0",
                                 .min = 0,
                                 .max = 4294967295.0};

/// Two tables of options as one.
template <size_t A, size_t B>
constexpr std::array<Option, A + B> joined(const Option (&a)[A], const Option (&b)[B]) {
  std::array<Option, A + B> all{};
  for (size_t i = 0; i < A; ++i) all[i] = a[i];
  for (size_t i = 0; i < B; ++i) all[A + i] = b[i];
  return all;
}

struct LoadedScene {
  Scene scene;
  double seconds;
};

/// Reads the scene and shows what was repaired or added.
LoadedScene load(const Arguments& arguments, const Session& session);

/// The outputs, each checked for a known extension and a place that can be written. @throws Error usage, io
std::vector<Path> checked_outputs(const Arguments& arguments, Session& session,
                                  std::span<const std::string_view> extensions);

/// Completes the report of a job: the command that was given, and the time of loading; shows its warnings.
void complete(Report& report, const LoadedScene& loaded, const Session& session);

}  // namespace aktina::app
