// What a patch is made of: the material's textures averaged over it.
#pragma once

#include <span>

#include "aktina/radiosity/mesher/source_faces.h"

namespace aktina {

/// Of the light that does not go straight through. Beyond it light would not die away; what goes through takes its
/// light along and is no reason to lower a reflectance.
inline constexpr float kMostReflectance = 0.99f;

struct PatchMaterial {
  Rgb reflectance, transmittance;
  Radiosity emission;
  bool clamped = false;  // the material reflects more than kMostReflectance
};

/// Averages materials of one instance over patches of its faces. Area averages in linear light; alpha is coverage: what
/// is not covered lets light straight through.
class PatchMaterials {
 public:
  PatchMaterials(const Scene& scene, const Instance& instance, const SourceFaces& faces);
  PatchMaterial average(const SourceFace& face, std::span<const Point3, 4> corners) const;

 private:
  PatchMaterial at(const SurfacePoint& place) const;
  int samples(const SourceFace& face, std::span<const Point3, 4> corners) const;

  const Scene& scene_;
  const Material& material_;
  const SourceFaces& faces_;
  bool uniform_;
  PatchMaterial everywhere_;
};

}  // namespace aktina
