// Surfaces that tests of view factors share.
#pragma once

#include <string>

#include "aktina/radiosity/viewfactor/view_factors.h"
#include "radiosity/formfactor/polygons.h"

namespace aktina {

/// Each polygon a surface of its own, named by its number.
inline ViewFactorScene one_each(std::vector<Polygon> polygons) {
  ViewFactorScene scene;
  for (uint32_t i = 0; i < polygons.size(); ++i) scene.owners.push_back(i), scene.names.push_back(std::to_string(i));
  scene.pieces = std::move(polygons);
  return scene;
}

}  // namespace aktina
