// What a radiosity solver leaves behind: patches of the scene and the light on them. Data; view independent.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "aktina/base/file.h"
#include "aktina/base/quantity.h"
#include "aktina/base/vec.h"
#include "aktina/base/warnings.h"

namespace aktina {

/// A place on the scene's geometry: a triangle of an instance, and barycentric coordinates of its vertices 1 and 2.
/// Instances of analytic primitives are tessellated first (tessellate_scene()), so every place is on a triangle.
struct SurfacePoint {
  uint32_t instance = 0, triangle = 0;
  float u = 0, v = 0;
};

/// Patches share vertices where the surface is smooth and their triangles share vertices in the mesh; a vertex belongs
/// to one instance, so that its texture coordinates and normal follow from `place`.
/// Neighbours agree on the points along their common edge: there are no T-junctions and no cracks.
struct PatchMesh {
  // Vertices.
  std::vector<Point3> positions;     // m, world
  std::vector<Vec3> normals;         // unit shading normals, world, front side
  std::vector<SurfacePoint> places;  // where each lies on the scene

  // Patches: triangles, or planar convex quadrilaterals; the last two corners of a triangle are equal.
  // Counter-clockwise seen from the front.
  std::vector<std::array<uint32_t, 4>> patches;
  std::vector<SurfacePoint> centres;  // of each patch
  std::vector<float> areas;           // m^2
  std::vector<Vec3> patch_normals;    // unit, geometric, front side
  std::vector<Rgb> reflectances;      // diffuse rho in [0, 1), textures averaged over the patch
  std::vector<Rgb> transmittances;    // tau, of light that goes straight through; rho + tau < 1
  std::vector<Radiosity> emissions;   // exitance E of its own, lm/m^2
  std::vector<uint8_t> two_sided;     // reflects and emits on both sides; else the back takes up all light

  /// Neighbouring patches of one face that shoot their light together: what radiosity literature calls a patch, where
  /// ours are its elements. Together all patches, in order, each once.
  struct Shooter {
    uint32_t first = 0, count = 1;
    std::array<uint32_t, 4> corners;  // their outline: vertices, as of a patch
  };
  std::vector<Shooter> shooters;

  size_t size() const { return patches.size(); }
  bool is_quad(size_t patch) const { return patches[patch][2] != patches[patch][3]; }
};

/// B = E + rho H for each patch. For a two-sided patch the values are those of the front; `back_*` hold the others.
struct Solution {
  PatchMesh mesh;
  // By patch.
  std::vector<Irradiance> irradiances;       // H, lx: all light that arrives, direct and indirect
  std::vector<Radiosity> radiosities;        // B, lm/m^2
  std::vector<Irradiance> back_irradiances;  // by patch; 0 where not two-sided
  std::vector<Irradiance> direct_irradiances, back_direct_irradiances;  // the part straight from lights and emitters
  // By vertex, reconstructed to be smooth over smooth surfaces.
  std::vector<Irradiance> vertex_irradiances;
  std::vector<Radiosity> vertex_radiosities;
  std::vector<Irradiance> vertex_back_irradiances;
  std::vector<Irradiance> vertex_direct_irradiances, vertex_back_direct_irradiances;

  // How it was made.
  std::string settings, scene_hash;
  uint64_t seed = 0;
  uint64_t steps = 0;                             // shots or iterations
  double unshot = 0;                              // flux not yet distributed over flux emitted; 0: converged
  double emitted = 0, absorbed = 0, escaped = 0;  // lm, sum over channels weighted as luminance; energy accounting
  bool converged = false;
  Warnings warnings;  // what was left out or changed: degenerate triangles, reflectances of 1
};

/// One binary file, little endian, versioned, with a checksum. @throws Error io
void save_solution(const Path& path, const Solution& solution);
/// @throws Error io, bad_input (truncated, corrupt, of another version), limit
Solution load_solution(const Path& path);
/// The same from memory. @param where  for messages
Solution decode_solution(std::span<const uint8_t> bytes, const std::string& where);

}  // namespace aktina
