#include "aktina/radiosity/mesher/patch_builder.h"

#include <fmt/core.h>

#include "aktina/base/error.h"

namespace aktina {

void PatchBuilder::reserve(size_t patches) {
  mesh_.positions.reserve(patches), mesh_.places.reserve(patches), mesh_.normals.reserve(patches);
  mesh_.patches.reserve(patches), mesh_.centres.reserve(patches), mesh_.areas.reserve(patches);
  mesh_.patch_normals.reserve(patches), mesh_.reflectances.reserve(patches), mesh_.transmittances.reserve(patches);
  mesh_.emissions.reserve(patches), mesh_.two_sided.reserve(patches);
}

void PatchBuilder::begin(uint32_t instance, const SourceFaces& faces) {
  faces_ = &faces;
  materials_ = std::make_unique<PatchMaterials>(scene_, scene_.instances[instance], faces);
  two_sided_ = scene_.material_of(scene_.instances[instance]).double_sided;
}

uint32_t PatchBuilder::add_vertex(const SourceFace& face, Point3 p) {
  const SurfacePoint place = faces_->place(face, p);
  mesh_.positions.push_back(p);
  mesh_.places.push_back(place);
  mesh_.normals.push_back(faces_->normal(place));
  return uint32_t(mesh_.positions.size()) - 1;
}

/// Along the normal.
Vec3d PatchBuilder::twice_area(const Corners& c) const {
  const auto p = [&](size_t k) { return Vec3d(mesh_.positions[c[k]]); };
  return c[2] != c[3] ? cross(p(2) - p(0), p(3) - p(1)) : cross(p(1) - p(0), p(2) - p(0));
}

bool PatchBuilder::has_area(const Corners& c) const { return float(length(twice_area(c)) / 2) > 0; }

void PatchBuilder::add_patch(const SourceFace& face, const Corners& c) {
  if (mesh_.size() >= most_)
    throw Error(Code::limit, "most_patches", fmt::format("the scene needs more than {} patches", most_),
                "a larger patch size, or a higher limit");
  const bool quad = c[2] != c[3];
  const std::array<Point3, 4> p = {mesh_.positions[c[0]], mesh_.positions[c[1]], mesh_.positions[c[2]],
                                   mesh_.positions[c[3]]};
  const Vec3d twice = twice_area(c);
  const Point3 centre = quad ? 0.25f * (p[0] + p[1] + p[2] + p[3]) : (p[0] + p[1] + p[2]) * (1.0f / 3);
  const PatchMaterial material = materials_->average(face, p);
  mesh_.patches.push_back(c);
  mesh_.centres.push_back(faces_->place(face, centre));
  mesh_.areas.push_back(float(length(twice) / 2));
  mesh_.patch_normals.push_back(normalize_or(Vec3(twice), {0, 1, 0}));
  mesh_.reflectances.push_back(material.reflectance);
  mesh_.transmittances.push_back(material.transmittance);
  mesh_.emissions.push_back(material.emission);
  mesh_.two_sided.push_back(two_sided_);
  clamped_ += material.clamped;
}

SceneFaces::SceneFaces(const Scene& scene) {
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (scene.instances[i].mesh < 0) continue;
    faces.emplace_back(scene, i);
    instances.push_back(i);
    degenerate += faces.back().degenerate;
  }
}

std::vector<Point3> SceneFaces::points() const {
  std::vector<Point3> all;
  for (const SourceFaces& each : faces) all.insert(all.end(), each.positions.begin(), each.positions.end());
  return all;
}

double SceneFaces::area() const {
  double sum = 0;
  for (const SourceFaces& each : faces)
    for (const SourceFace& f : each.list) {
      const Vec3d a(each.positions[f.corners[0]]), b(each.positions[f.corners[1]]), c(each.positions[f.corners[2]]),
          d(each.positions[f.corners[3]]);
      sum += 0.5 * length(f.is_quad() ? cross(c - a, d - b) : cross(b - a, c - a));
    }
  return sum;
}

void warn_of_repairs(const SceneFaces& faces, const PatchBuilder& builder, Warnings& warnings) {
  if (faces.degenerate) warnings.add("triangles without area, or not finite, are left out", faces.degenerate);
  if (builder.clamped())
    warnings.add(fmt::format("patches that reflect more than {} are taken to reflect that", kMostReflectance),
                 builder.clamped());
}

}  // namespace aktina
