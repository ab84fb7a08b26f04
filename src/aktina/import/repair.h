// What every reader does to a mesh before it enters a scene: triangles and attributes that nothing can be computed from
// are dropped or mended, and counted.
#pragma once

#include "aktina/base/warnings.h"
#include "aktina/scene/mesh.h"

namespace aktina {

/// Drops triangles with indices beyond the vertices, positions that are not finite (or farther than 1e15 m) or no area,
/// then vertices that no triangle uses; normalizes normals and tangents, replaces what is not finite.
/// @param stitched  triangles that name a vertex twice are part of the format (strips) and not worth a warning
void repair(Mesh& mesh, Warnings& warnings, bool stitched = false);

/// Tangents along which the first UV coordinate grows, where normal maps need them and the file has none: the
/// area-weighted mean over the triangles at a vertex, orthogonal to its normal (E. Lengyel, "Foundations of Game Engine
/// Development 2", 2019, section 7.5). Needs normals and UVs of the set.
void generate_tangents(Mesh& mesh, int uv_set);

}  // namespace aktina
