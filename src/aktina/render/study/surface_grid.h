// Meshes over a grid of two parameters.
#pragma once

#include "aktina/base/function_ref.h"
#include "aktina/scene/mesh.h"

namespace aktina {

struct SurfacePoint3 {
  Vec3d position, normal;  // m; unit, on the side of the front
};

/// Adds columns x rows quadrilaterals over the unit square, as two triangles each, turned to the side of their normals;
/// triangles without area are left out. Places are rounded to a millionth of a metre, so that neighbouring surfaces
/// meet.
void add_grid(Mesh& mesh, int columns, int rows, FunctionRef<SurfacePoint3(double u, double v)> at);

}  // namespace aktina
