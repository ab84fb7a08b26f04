// What the readers of polygon files share.
#pragma once

#include <string>

#include "aktina/import/import.h"

namespace aktina {

/// Adds the triangles and vertices of `more`; attributes that only one of both has are filled with 0 (colours: white).
void append(Mesh& mesh, const Mesh& more);

/// Repairs a mesh, gives it normals where it has none, and adds it with an instance at `node`. A mesh of which nothing
/// is left is not added.
void add_mesh(Scene& scene, Mesh mesh, const ImportOptions& options, int node = -1);

/// Units, up axis and what else a file leaves out: metres per unit from the options (else 1), default camera and light.
/// @throws Error bad_input "nothing to draw" if the scene has no instance; `instead` says what there is
void finish_scene(Scene& scene, const ImportOptions& options, const std::string& instead);

}  // namespace aktina
