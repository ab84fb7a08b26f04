// Rectangular and disc lights of a scene: what rays find of them.
#include <gtest/gtest.h>

#include "aktina/scene/scene_lights.h"
#include "trace/integrator/light_scenes.h"

namespace aktina {
namespace {

const Light kLights[] = {
    RectangleLight{
        .corner = {-0.4f, 2, -0.6f}, .edge_u = {0.8f, 0, 0}, .edge_v = {0, 0, 1.2f}, .radiance = Radiance(Rgb(10))},
    DiscLight{.position = {0.2f, 1.5f, 0}, .direction = {0, -1, 0}, .radius = 0.5f, .radiance = Radiance(Rgb(10))}};

Scene scene_with(const Light& light) {
  Scene scene;
  test::set_matt(test::add(scene, test::quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9})), Rgb(1));
  place_light(scene, {"", light, -1});
  return scene;
}

TEST(AreaLight, LightsAFloorAsItsClosedFormSays) {
  for (const Light& light : kLights) {
    const Scene scene = scene_with(light);
    const LightSample s = sample(light, {0.3f, 0, 0.2f});
    const double exact = double(s.e_perp.v.g * s.wi.y) / kPi;
    for (const char* method : {"path", "direct", "direct:strategy=1", "direct:strategy=2"})
      EXPECT_MEAN(test::estimates(scene, {0.3f, 1, 0.2f}, {0, -1, 0}, method, 64, 16), exact);
    EXPECT_NEAR(double(test::along(scene, {0.3f, 1, 0.2f}, {0, -1, 0}, test::options("whitted", 1)).g), exact,
                1e-4 * exact);
  }
}

TEST(AreaLight, IsSeenByRaysFromItsFront) {
  for (const Light& light : kLights) {
    const Scene scene = scene_with(light);
    for (const char* method : {"path", "direct", "whitted"}) {
      EXPECT_FLOAT_EQ(test::along(scene, {0.1f, 1, 0.1f}, {0, 1, 0}, test::options(method, 4)).g, 10) << method;
      EXPECT_EQ(test::along(scene, {0.1f, 3, 0.1f}, {0, -1, 0}, test::options(method, 4)).g, 0) << method;
    }
  }
}

}  // namespace
}  // namespace aktina
