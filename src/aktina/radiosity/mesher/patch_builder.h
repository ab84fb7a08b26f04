// What all meshers share: vertices and patches of faces, with all that a PatchMesh says about them.
#pragma once

#include <array>
#include <memory>

#include "aktina/radiosity/mesher/patch_material.h"
#include "aktina/radiosity/mesher/source_faces.h"

namespace aktina {

/// Adds to a mesh, one instance after another.
class PatchBuilder {
 public:
  using Corners = std::array<uint32_t, 4>;  // vertices; the last two of a triangle are equal

  /// @param most  patches that the mesh may have
  PatchBuilder(PatchMesh& mesh, const Scene& scene, uint64_t most) : mesh_(mesh), scene_(scene), most_(most) {}

  /// About so many patches are to come.
  void reserve(size_t patches);
  /// The faces that follow are of this instance; `faces` must outlive the calls.
  void begin(uint32_t instance, const SourceFaces& faces);
  uint32_t add_vertex(const SourceFace& face, Point3 p);
  /// Whether the corners, as rounded to floats, bound an area: slivers between cuts may not, and are no patches.
  bool has_area(const Corners& corners) const;
  /// A part of the face, planar, convex and with an area. Shooters are the caller's. @throws Error limit (too many
  /// patches)
  void add_patch(const SourceFace& face, const Corners& corners);
  /// Patches whose materials reflect more than kMostReflectance.
  uint64_t clamped() const { return clamped_; }

 private:
  Vec3d twice_area(const Corners& corners) const;

  PatchMesh& mesh_;
  const Scene& scene_;
  uint64_t most_, clamped_ = 0;
  const SourceFaces* faces_ = nullptr;
  std::unique_ptr<PatchMaterials> materials_;
  bool two_sided_ = false;
};

/// All that meshers cut: the faces of each instance that has a mesh.
struct SceneFaces {
  explicit SceneFaces(const Scene& scene);
  std::vector<SourceFaces> faces;
  std::vector<uint32_t> instances;  // of each of them
  uint64_t degenerate = 0;
  std::vector<Point3> points() const;  // all corners
  double area() const;                 // m^2
};

/// Says in `warnings` what was left out of the faces or changed in the patches.
void warn_of_repairs(const SceneFaces& faces, const PatchBuilder& builder, Warnings& warnings);

}  // namespace aktina
