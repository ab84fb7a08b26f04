// Scene -> the surfaces of a view-factor matrix.
#pragma once

#include "aktina/radiosity/viewfactor/view_factors.h"
#include "aktina/scene/scene.h"

namespace aktina {

enum class SurfacesBy : uint8_t { face, object, material };

/// Of polygons of two-sided materials.
enum class Backs : uint8_t { hide, see };

/// Of surfaces that let light through: they hide all, as glass does for heat, or their material's alpha and
/// transmission (by luminance, without textures) goes straight on.
enum class Clear : uint8_t { hide, pass };

/// One surface for each polygon of the file (a face of an OBJ, PLY or OFF file as it stands there; of formats that have
/// only triangles: two consecutive ones that make a parallelogram, else one), each object or each material. Names are
/// the file's: "wall", or "wall:3" for polygon 3 of an object with several. Coordinates in metres, world.
/// Polygons that have holes, cross themselves or are not planar become surfaces of several triangles; those without
/// area, and those that stand where there is one already, are left out and counted.
/// With Backs::see the backs of two-sided materials take part: by face as surfaces "wall/back" of their own after each
/// front, else with their object or material, whose area is then that of both sides.
/// @throws Error bad_input (nothing with an area), limit (more than 2^31 pieces)
ViewFactorScene surfaces_of(const Scene& scene, SurfacesBy by, Backs backs = Backs::hide, Clear clear = Clear::hide);

}  // namespace aktina
