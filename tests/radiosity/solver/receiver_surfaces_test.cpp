#include "aktina/radiosity/solver/receiver_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/shooter_hits.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

Scene room_with_box() {
  Scene scene = room({2, 2, 2}, Rgb(0.6f));
  add_box(scene, {0.5f, 0, 0.5f}, {0.5f, 0.5f, 0.5f}, Rgb(0.7f));
  add_quad(scene, {0.2f, 1, 0.2f}, {0.3f, 0, 0}, {0, 0.3f, 0}, Rgb(0.5f));
  scene.materials.back().double_sided = true;
  return scene;
}

PatchMesh mesh_of(const Scene& scene) {
  Warnings warnings;
  return make_method(meshers(), "mesher", "uniform")->mesh(scene, {.patch_size = 0.1, .coarse = 1}, warnings);
}

Vec3d twice_area(const std::array<Point3, 4>& c) {
  const auto p = [&](size_t k) { return Vec3d(c[k]); };
  return c[2] != c[3] ? cross(p(2) - p(0), p(3) - p(1)) : cross(p(1) - p(0), p(2) - p(0));
}

/// Pieces lie on their faces, as the faces are turned, and cover `covered` of their area; returns areas by receiver.
std::vector<double> check(const SurfaceLayout& layout, size_t receivers, double covered) {
  std::vector<double> areas(receivers, 0);
  double all = 0;
  EXPECT_EQ(layout.first_pieces.size(), layout.faces.size() + 1);
  for (size_t f = 0; f < layout.faces.size(); ++f) {
    const SurfaceLayout::Face& face = layout.faces[f];
    EXPECT_GT(dot(twice_area(face.corners), Vec3d(face.normal)), 0);
    for (size_t k = layout.first_pieces[f]; k < layout.first_pieces[f + 1]; ++k) {
      const SurfaceLayout::Piece& piece = layout.pieces[k];
      EXPECT_NEAR(0.5 * dot(twice_area(piece.corners), Vec3d(face.normal)), piece.area, 1e-6);
      for (const Point3 p : piece.corners) EXPECT_NEAR(dot(p - face.corners[0], face.normal), 0, 1e-5f);
      areas[piece.receiver] += piece.area, all += piece.area;
    }
  }
  EXPECT_NEAR(all, covered, 1e-4);
  return areas;
}

constexpr double kArea = 24 + 6 * 0.25 + 2 * 0.09;

TEST(ReceiverSurfaces, SidesAreThePiecesOfTheirFaces) {
  const Scene scene = room_with_box();
  const PatchMesh mesh = mesh_of(scene);
  const Sides sides(mesh);
  const ShotGeometry geometry(sides);
  const Visibility visibility(scene);
  const SurfaceLayout layout = ReceiverSurfaces(scene, geometry, visibility).layout();
  EXPECT_EQ(layout.faces.size(), 6U + 6U + 2U);
  const std::vector<double> areas = check(layout, sides.size(), kArea);
  for (size_t s = 0; s < sides.size(); ++s) EXPECT_NEAR(areas[s], double(mesh.areas[sides.patch(s)]), 1e-9);
}

TEST(ReceiverSurfaces, CoarsePatchesHaveAllTheirSidesThatCount) {
  const Scene scene = room_with_box();
  const PatchMesh mesh = mesh_of(scene);
  const Sides sides(mesh);
  const std::vector<float> open = ShooterHits(sides).open_shares();
  const Visibility visibility(scene);
  const CoarsePatches patches(sides, 0.5, open, visibility);
  const ShotGeometry geometry(sides, patches, false);
  double counted = 0;
  for (size_t i = 0; i < patches.size(); ++i) counted += patches.area(i);
  EXPECT_LT(counted, kArea - 0.1) << "floor below the box";
  const std::vector<double> areas =
      check(ReceiverSurfaces(scene, geometry, visibility).layout(), patches.size(), counted);
  for (size_t i = 0; i < patches.size(); ++i) EXPECT_NEAR(areas[i], patches.area(i), 1e-6);
}

}  // namespace
}  // namespace aktina
