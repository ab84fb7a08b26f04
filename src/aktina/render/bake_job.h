// The light of a solution as files for viewers that compute none.
#pragma once

#include <optional>

#include "aktina/radiosity/lightmap/lightmap.h"
#include "aktina/render/job.h"

namespace aktina {

/// How a model carries its light: "vertex", "emissive" or "lightmap".
std::vector<std::string_view> bake_forms();

/// What is written from one solution: the lightmap is made once, where a file needs it.
class Baking {
 public:
  /// @param form  of models: a word of bake_forms(). @param exposure  0: lit_exposure(). Both must outlive this.
  /// @throws Error usage (another form)
  Baking(const Scene& scene, Radiosities& radiosities, std::string form, float exposure, LightmapOptions options);

  /// .glb and .gltf: the model, with form "lightmap" and an .exr of the map beside it; .exr: the map alone, a file a
  /// page. The report gets what the lightmap took. Where `progress` is cancelled, the map has what the solution says.
  /// @return  the files written. @throws Error io, limit, bad_param, unsupported, usage
  std::vector<Path> write(const Path& path, Progress& progress);
  /// What is written beside a model; empty: nothing.
  static Path beside(const Path& model, std::string_view form);

 private:
  const Lightmap& lightmap(Progress& progress);
  void make_lightmap(Progress& progress);

  const Scene& scene_;
  Radiosities& radiosities_;
  std::string form_;
  float exposure_;
  LightmapOptions options_;
  std::optional<Lightmap> lightmap_;
};

}  // namespace aktina
