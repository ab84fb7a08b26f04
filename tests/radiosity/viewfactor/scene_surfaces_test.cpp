#include "aktina/radiosity/viewfactor/scene_surfaces.h"

#include <gmock/gmock.h>

#include "aktina/base/error.h"
#include "aktina/radiosity/viewfactor/outline.h"

namespace aktina {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Triangles = std::vector<std::array<uint32_t, 3>>;

TEST(Outline, OfAFanIsThePolygon) {
  EXPECT_THAT(outline_of(Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}), ElementsAre(0, 1, 2, 3, 4));
}

TEST(Outline, OfARingOrOfPartsThatTouchIsNone) {
  EXPECT_THAT(
      outline_of(Triangles{{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6}, {3, 7, 6}, {3, 0, 7}, {0, 4, 7}}),
      IsEmpty())
      << "a hole";
  EXPECT_THAT(outline_of(Triangles{{0, 1, 2}, {0, 3, 4}}), IsEmpty()) << "in a corner";
  EXPECT_THAT(outline_of(Triangles{{0, 1, 2}, {3, 4, 5}}), IsEmpty()) << "apart";
}

Mat4 raised(float z) {
  Mat4 m(1);
  m[3].z = z;
  return m;
}

/// A square in z = 0 as two triangles, the second of material 1, with or without their polygon.
Scene square(bool stated) {
  Scene scene;
  Mesh mesh;
  mesh.name = "plate";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (stated) mesh.triangle_face = {0, 0}, mesh.face_count = 1;
  scene.meshes.push_back(mesh);
  scene.instances.push_back({.mesh = 0});
  return scene;
}

TEST(SurfacesOf, PolygonsStayPolygonsAndKeepTheirName) {
  for (const bool stated : {true, false}) {
    const ViewFactorScene surfaces = surfaces_of(square(stated), SurfacesBy::face);
    ASSERT_EQ(surfaces.pieces.size(), 1U);
    EXPECT_EQ(surfaces.pieces[0].vertices.size(), 4U);
    EXPECT_THAT(surfaces.names, ElementsAre("plate"));
  }
}

TEST(SurfacesOf, FacesOfOneObjectAreNumbered) {
  Scene scene = square(true);
  scene.meshes[0].triangle_face = {0, 1}, scene.meshes[0].face_count = 2;
  EXPECT_THAT(surfaces_of(scene, SurfacesBy::face).names, ElementsAre("plate:0", "plate:1"));
  const ViewFactorScene whole = surfaces_of(scene, SurfacesBy::object);
  EXPECT_THAT(whole.names, ElementsAre("plate"));
  EXPECT_THAT(whole.owners, ElementsAre(0, 0));
}

TEST(SurfacesOf, MirroredInstancesFaceTheOtherWayRound) {
  Scene scene = square(true);
  scene.instances[0].to_world[0][0] = -1;
  const ViewFactorScene surfaces = surfaces_of(scene, SurfacesBy::face);
  EXPECT_GT(newell_normal(surfaces.pieces[0]).z, 0) << "the front stays in front";
}

TEST(SurfacesOf, ByMaterialOverAllObjects) {
  Scene scene = square(true);
  scene.materials.resize(2);
  scene.materials[0].name = "paint";
  scene.instances[0].material = 0;
  scene.instances.push_back({.mesh = 0, .material = 1, .to_world = raised(1)});
  scene.instances.push_back({.mesh = 0, .material = 0, .to_world = raised(2)});
  const ViewFactorScene surfaces = surfaces_of(scene, SurfacesBy::material);
  EXPECT_THAT(surfaces.names, ElementsAre("paint", "material 1"));
  EXPECT_THAT(surfaces.owners, ElementsAre(0, 1, 0));
}

TEST(SurfacesOf, WhatIsNotPlanarBecomesTrianglesOfOneSurface) {
  Scene scene = square(true);
  scene.meshes[0].positions[2].z = 0.2F;
  const ViewFactorScene surfaces = surfaces_of(scene, SurfacesBy::face);
  EXPECT_EQ(surfaces.pieces.size(), 2U);
  EXPECT_THAT(surfaces.owners, ElementsAre(0, 0));
  EXPECT_FALSE(surfaces.warnings.empty());
}

TEST(SurfacesOf, BacksOfTwoSidedMaterialsTakePartWhereAsked) {
  Scene scene = square(false);
  scene.meshes[0].positions.insert(scene.meshes[0].positions.end(), {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
  scene.meshes[0].triangles.push_back({4, 5, 6});
  scene.materials.resize(2);
  scene.materials[1].double_sided = true;
  scene.instances = {{.mesh = 0, .material = 1}, {.mesh = 0, .material = 0, .to_world = raised(1)}};
  scene.meshes[0].name = "plate";
  const ViewFactorScene surfaces = surfaces_of(scene, SurfacesBy::face, Backs::see);
  EXPECT_THAT(surfaces.names, ElementsAre("plate:0", "plate:0/back", "plate:1", "plate:1/back", "plate:0", "plate:1"));
  EXPECT_GT(newell_normal(surfaces.pieces[0]).z, 0);
  EXPECT_LT(newell_normal(surfaces.pieces[1]).z, 0);
  EXPECT_THAT(surfaces_of(scene, SurfacesBy::object, Backs::see).owners, ElementsAre(0, 0, 0, 0, 1, 1));
  EXPECT_EQ(surfaces_of(scene, SurfacesBy::face).pieces.size(), 4U);
}

TEST(SurfacesOf, WhatStandsTwiceInOnePlaceCountsOnce) {
  Scene scene = square(true);
  Mesh again = scene.meshes[0];
  again.positions = {{1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}};
  scene.meshes.push_back(again);
  std::swap(again.triangles[0][0], again.triangles[0][1]), std::swap(again.triangles[1][0], again.triangles[1][1]);
  scene.meshes.push_back(again);  // its back
  scene.instances = {{.mesh = 0}, {.mesh = 1}, {.mesh = 2}};
  const ViewFactorScene surfaces = surfaces_of(scene, SurfacesBy::face);
  EXPECT_EQ(surfaces.pieces.size(), 2U);
  EXPECT_FALSE(surfaces.warnings.empty());
}

TEST(SurfacesOf, NothingWithAnAreaIsAnError) {
  Scene scene = square(true);
  for (Point3& p : scene.meshes[0].positions) p = {0, 0, 0};
  EXPECT_THROW(surfaces_of(scene, SurfacesBy::face), Error);
}

}  // namespace
}  // namespace aktina
