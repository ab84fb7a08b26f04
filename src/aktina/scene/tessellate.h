// Analytic primitives as meshes, for methods that know triangles only.
#pragma once

#include <optional>

#include "aktina/scene/scene.h"

namespace aktina {

/// The scene with each analytic primitive replaced by triangles on its surface, at most a five-hundredth of its size
/// away from it: the same triangles every time, so that places on them can be kept (SurfacePoint). Instances, materials
/// and everything else keep their indices; meshes are added at the end. The scene itself where it has no primitives:
/// it must outlive this.
class TessellatedScene {
 public:
  explicit TessellatedScene(const Scene& scene);
  const Scene& operator*() const { return own_ ? *own_ : *scene_; }
  const Scene* operator->() const { return &**this; }

 private:
  const Scene* scene_;
  std::optional<Scene> own_;
};

}  // namespace aktina
