// How the triangles of one material are drawn in a frame.
#pragma once

#include <memory>

#include "aktina/raster/draw_list.h"
#include "aktina/raster/plane_layout.h"
#include "aktina/raster/rasterize.h"
#include "aktina/scene/scene_lights.h"

namespace aktina {

/// Coefficients where no rays are traced: mirrors show the even ambient light, and glass scatters what it would let
/// through, as viewers without refraction draw it.
inline Surface without_rays(Surface s) {
  s.ka += s.kr + s.kt, s.kd += s.kt;
  s.transmission = 0;
  return s;
}

/// What stays the same from frame to frame.
struct PipelineSettings {
  std::shared_ptr<const ShadingMethod> method, unlit;  // unlit: linear on the surface
  IlluminationModel model;
  SceneLights lights;
  DepthCue cue{};               // eye and forward follow the view
  bool cull = false;            // RasterOptions::cull_back_faces
  bool surface_layers = false;  // layers that need the surface's coordinates: albedo, N
};

struct Pipeline {
  Pipeline(const PipelineSettings& settings, const Material& material, bool coloured, const Viewer& viewer);

  const Material* material;
  const ShadingMethod* method;
  bool textured;      // coefficients differ from point to point
  Illuminator light;  // of a textured surface: as if white, without ambient light; textures come after
  ShadingPlan plan;
  PlaneLayout layout;
  bool coloured;   // the mesh has vertex colours
  bool lit;        // else the colour is the emission that evaluate() gives
  bool immediate;  // colour is written as triangles come; else visible pixels are shaded afterwards
  bool cull;
  Rgb emission;  // of one that is not textured

  /// Of TriangleGroup::radiance.
  int radiance_channels() const { return plan.kind != ShadingPlan::Kind::colour || layout.channels == 6 ? 6 : 3; }
  bool spans() const { return plan.kind == ShadingPlan::Kind::spans; }
  bool blended() const { return material->alpha_mode == AlphaMode::blend; }
  bool masked() const { return material->alpha_mode == AlphaMode::mask; }
  bool emits_on(bool front) const { return front || material->double_sided || material->unlit; }
};

/// Pipelines of the parts of a draw list, and which one each part has.
struct Pipelines {
  std::vector<Pipeline> all;
  std::vector<uint32_t> of_part;
  size_t lines = 0;  // of planes a triangle has at most
  bool any_deferred = false, any_blended = false, any_spans = false;
  bool any_radiance = false, any_specular = false;  // at vertices; apart

  Pipelines(const PipelineSettings& settings, const DrawList& list, const Viewer& viewer);
};

}  // namespace aktina
