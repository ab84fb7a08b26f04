#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/scene/scene_lights.h"

namespace aktina {
namespace {

const RectangleLight kPanel{
    .corner = {-0.4f, 2, -0.6f}, .edge_u = {0.8f, 0, 0}, .edge_v = {0, 0, 1.2f}, .radiance = Radiance({10, 20, 30})};
const DiscLight kDisc{.position = {1, 2, 3},
                      .direction = {0.6f, -0.8f, 0},
                      .radius = 0.3f,
                      .radiance = Radiance(Rgb(5)),
                      .both_sides = true};

TEST(AreaLights, StandAsSurfacesAndAreFoundAgain) {
  Scene scene;
  place_light(scene, {"panel", kPanel, -1});
  place_light(scene, {"disc", kDisc, -1});
  place_light(scene, {"lamp", PointLight{}, -1});
  EXPECT_EQ(scene.lights.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  const SceneLights lights = scene_lights(scene);
  ASSERT_EQ(lights.lights.size(), 3u);
  EXPECT_EQ(lights.instance, (std::vector<int>{-1, 0, 1}));
  for (const Point3 x : {Point3(0, 0, 0), Point3(2, 0.5f, 1), Point3(-1, 1, 4)}) {
    EXPECT_NEAR(sample(lights.lights[1], x).e_perp.v.b, sample(kPanel, x).e_perp.v.b, 1e-4f);
    EXPECT_NEAR(sample(lights.lights[2], x).e_perp.v.b, sample(kDisc, x).e_perp.v.b, 1e-4f);
  }
}

TEST(AreaLights, AnyOrderOfCornersIsAPanel) {
  for (int first = 0; first < 3; ++first)
    for (int second = 0; second < 3; ++second) {
      Scene scene;
      place_light(scene, {"", kPanel, -1});
      auto& t = scene.meshes[0].triangles;
      std::rotate(t[0].begin(), t[0].begin() + first, t[0].end());
      std::rotate(t[1].begin(), t[1].begin() + second, t[1].end());
      const auto light = flat_light(scene, scene.instances[0]);
      ASSERT_TRUE(light);
      EXPECT_NEAR(sample(*light, {1, 0, 0}).e_perp.v.g, sample(kPanel, {1, 0, 0}).e_perp.v.g, 1e-4f);
      EXPECT_EQ(sample(*light, {1, 4, 0}).e_perp.v.g, 0);
    }
}

TEST(AreaLights, OtherShapesAreNone) {
  Scene scene;
  place_light(scene, {"", kPanel, -1});
  scene.meshes[0].positions[2].x += 0.1f;
  EXPECT_FALSE(flat_light(scene, scene.instances[0]));
  Scene discs;
  place_light(discs, {"", kDisc, -1});
  discs.instances[0].to_world[0] *= 2.0f;
  EXPECT_FALSE(flat_light(discs, discs.instances[0])) << "an ellipse";
}

TEST(AreaLights, FaultsAreErrors) {
  Scene scene;
  RectangleLight flat = kPanel;
  flat.edge_v = flat.edge_u;
  EXPECT_THROW(place_light(scene, {"", flat, -1}), Error);
  DiscLight none = kDisc;
  none.radius = 0;
  EXPECT_THROW(place_light(scene, {"", none, -1}), Error);
  none.radius = 1, none.radiance = Radiance(Rgb(-1));
  EXPECT_THROW(place_light(scene, {"", none, -1}), Error);
}

}  // namespace
}  // namespace aktina
