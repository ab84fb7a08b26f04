#include "aktina/radiosity/mesher/source_faces.h"

#include <gtest/gtest.h>

#include "radiosity/scenes.h"

namespace aktina {
namespace {

TEST(SourceFaces, QuadrilateralsAreFoundAtAnySizeAndWhereCoordinatesAreRounded) {
  for (const float size : {1e-6f, 4e-3f, 1.0f, 1e6f}) {
    Scene scene;
    const Vec3 u = Vec3(0.8f, 0.6f, 0) * size, v = Vec3(-0.6f, 0.8f, 0) * (0.37f * size);
    add_quad(scene, Point3(0), u, v, Rgb(0.5f));
    if (size == 4e-3f) add_quad(scene, {3.7f, 2.9f, 0}, u, v, Rgb(0.5f));  // roundings are 1e-4 of it
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
      const SourceFaces faces(scene, i);
      ASSERT_EQ(faces.list.size(), 1U) << size;
      EXPECT_TRUE(faces.list[0].is_quad()) << size;
    }
  }
}

TEST(SourceFaces, TrapezesAreTwoTriangles) {
  Scene scene;
  add_quad(scene, {3.7f, 2.9f, 0}, {4e-3f, 0, 0}, {0, 4e-3f, 0}, Rgb(0.5f));
  scene.meshes[0].positions[2].x -= 4e-5f;
  EXPECT_EQ(SourceFaces(scene, 0).list.size(), 2U);
}

}  // namespace
}  // namespace aktina
