// A scene, prepared for rays: what all integrators share.
#pragma once

#include <memory>
#include <string_view>

#include "aktina/scene/scene.h"
#include "aktina/trace/accelerator/accelerator.h"
#include "aktina/trace/light_sampler.h"
#include "aktina/trace/surface_table.h"

namespace aktina {

struct RayScene {
  /// @param accelerator_choice  a row of accelerators(); empty: the fastest one for the scene
  /// `scene` must outlive this. @throws Error no_such_method, bad_param, bad_input, limit
  RayScene(const Scene& scene, std::string_view accelerator_choice);

  const Scene& scene;
  SurfaceTable surfaces;
  LightSampler lights;
  std::unique_ptr<Accelerator> accelerator;
};

}  // namespace aktina
