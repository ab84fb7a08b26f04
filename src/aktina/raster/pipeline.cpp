#include "aktina/raster/pipeline.h"

#include <algorithm>
#include <map>

namespace aktina {
namespace {

bool has_textures(const Material& m) {
  return m.base_texture || m.metallic_roughness_texture || m.normal_texture || m.emission_texture ||
         m.transmission_texture || m.specular_texture || m.specular_tint_texture;
}

/// What textured surfaces are lit as where their coefficients are not known yet: white, without ambient light.
Surface blank(Surface s) {
  s.ka = Rgb(0), s.kd = Rgb(1), s.ks = Rgb(1);
  s.base = Rgb(1), s.metallic = 0, s.transmission = 0;
  return s;
}

}  // namespace

Pipeline::Pipeline(const PipelineSettings& settings, const Material& m, bool has_colours, const Viewer& viewer)
    : material(&m),
      method(m.unlit ? settings.unlit.get() : settings.method.get()),
      textured(has_textures(m) || m.alpha_mode != AlphaMode::opaque || (has_colours && !m.unlit) ||
               settings.surface_layers),
      light(settings.model, textured ? blank(surface_of(m)) : without_rays(surface_of(m)), settings.lights.lights,
            settings.lights.ambient, viewer),
      plan(method->plan(light)),
      coloured(has_colours),
      lit(!m.unlit),
      cull(settings.cull && !m.double_sided),
      emission(m.unlit ? Rgb() : m.emission.v) {
  const bool colour = plan.kind == ShadingPlan::Kind::colour;
  layout.degree = plan.degree, layout.perspective = plan.perspective, layout.surface = textured;
  layout.channels = colour ? (textured ? (lit ? 6 : 0) : 3) : plan.channels;
  immediate = colour && !textured;
  if (spans()) plan.needs |= ShadingPlan::kScreen;  // where they begin and end
}

Pipelines::Pipelines(const PipelineSettings& settings, const DrawList& list, const Viewer& viewer) {
  std::map<std::pair<const Material*, bool>, uint32_t> known;
  for (const DrawPart& part : list.parts()) {
    const bool coloured = !part.mesh->colours.empty();
    const auto [at, added] = known.try_emplace({part.material, coloured}, uint32_t(all.size()));
    if (added) all.emplace_back(settings, *part.material, coloured, viewer);
    of_part.push_back(at->second);
  }
  for (const Pipeline& p : all) {
    lines = std::max(lines, p.layout.lines());
    any_deferred = any_deferred || !p.immediate;
    any_blended = any_blended || p.blended();
    any_spans = any_spans || p.spans();
    if (!(p.plan.needs & ShadingPlan::kRadiance)) continue;
    any_radiance = true;
    any_specular = any_specular || p.radiance_channels() == 6;
  }
}

}  // namespace aktina
