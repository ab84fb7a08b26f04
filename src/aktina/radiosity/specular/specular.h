// How light by way of mirrors and glass is added to a radiosity solution when a picture is made.
#pragma once

#include <memory>
#include <span>

#include "aktina/base/method.h"
#include "aktina/radiosity/solve.h"

namespace aktina {

class SpecularMethod {
 public:
  virtual ~SpecularMethod() = default;
  /// @throws Error usage (a solution of another scene), bad_param, limit; cancelled (nothing is there yet)
  virtual LayeredImage render(const Scene& scene, const Solution& solution, const Camera& camera, int width, int height,
                              const TwoPassOptions& options, Progress* progress) const = 0;
};

std::span<const Method<std::unique_ptr<SpecularMethod>>* const> specular_methods();

}  // namespace aktina
