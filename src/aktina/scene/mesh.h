// Indexed triangle meshes, remembering the polygons they came from.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "aktina/base/vec.h"
#include "aktina/illumination/normals/normals.h"

namespace aktina {

/// Attributes are empty or as long as `positions`. Triangles counter-clockwise seen from the front.
struct Mesh {
  std::string name;
  std::vector<Point3> positions;  // m, in the mesh's own space
  std::vector<Vec3> normals;      // unit
  std::vector<Vec4> tangents;     // unit xyz; w: handedness, +1 or -1
  std::vector<Vec2> uv[2];        // v down, as glTF has it
  std::vector<Vec4> colours;      // linear RGBA
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> triangle_face;  // source polygon of each triangle; empty: each triangle is its own
  uint32_t face_count = 0;              // where triangle_face is not empty
  int material = -1;                    // index into Scene::materials; -1: Scene::material_of says

  uint32_t face_of(uint32_t triangle) const { return triangle_face.empty() ? triangle : triangle_face[triangle]; }
  uint32_t faces() const { return triangle_face.empty() ? uint32_t(triangles.size()) : face_count; }
};

/// Twice the area times the unit normal of a triangle: cross product of two edges. m^2
inline Vec3 triangle_cross(const Mesh& mesh, const std::array<uint32_t, 3>& t) {
  const Point3 a = mesh.positions[t[0]];
  return cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
}

Bounds bounds(const Mesh& mesh);
/// Fills missing normals: smooth over vertices that share a position, split at edges sharper than `crease` (rad), at
/// edges of more than two faces and where faces touch in a point only. A face by itself gets its flat normal, so with
/// crease = 0 every face is flat, as glTF asks where a file has no normals. Vertices are doubled where normals differ.
/// @param weighting  of the facets around a vertex: the product of a row of normals()
void generate_normals(Mesh& mesh, float crease, FacetWeighting weighting = default_weighting());

}  // namespace aktina
