#include "aktina/radiosity/lightmap/lightmap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "radiosity/lightmap/surfaces.h"

namespace aktina {
namespace {

/// A box room with a lamp under its ceiling and a box on its floor.
Scene furnished() {
  Scene scene = room({3, 2.5f, 3}, Rgb(0.6f));
  add_box(scene, {1, 0, 1}, {0.8f, 0.8f, 0.8f}, Rgb(0.3f, 0.5f, 0.7f));
  add_quad(scene, {1.2f, 2.4f, 1.2f}, Vec3(0.6f, 0, 0), Vec3(0, 0, 0.6f), Rgb(0), Rgb(5000));
  return scene;
}

Solution solved(const Scene& scene, double patch_size = 0.1) {
  RadiosityOptions options;
  options.patch_size = patch_size;
  return solve_radiosity(scene, options);
}

LightmapOptions of_solution(double texel_size) {
  LightmapOptions options;
  options.texel_size = texel_size;
  options.direct_samples = 0;
  return options;
}

/// What a viewer reads between texels.
Rgb look_up(const Image& page, Vec2 texel) {
  const Vec2 p = texel - 0.5f, corner = glm::floor(p), f = p - corner;
  Rgb sum;
  for (int k = 0; k < 4; ++k)
    sum += page.rgb(std::clamp(int(corner.x) + k % 2, 0, page.width - 1),
                    std::clamp(int(corner.y) + k / 2, 0, page.height - 1)) *
           ((k % 2 ? f.x : 1 - f.x) * (k / 2 ? f.y : 1 - f.y));
  return sum;
}

TEST(Lightmap, HasTheSolutionsValuesAtItsVertices) {
  const Scene scene = furnished();
  const Solution solution = solved(scene);
  const Lightmap map = make_lightmap(scene, solution, of_solution(0.02));
  double error = 0, level = 0;
  size_t compared = 0;
  for (const PlacedChart& chart : map.layout.charts) {
    const LightmapSurface& surface = map.layout.surfaces[chart.surface];
    for (size_t v = 0; v < solution.mesh.positions.size(); ++v) {
      const SurfacePoint at = solution.mesh.places[v];
      if (at.instance != surface.instance) continue;
      for (size_t i = 0; i < chart.triangles.size(); ++i) {
        if (surface.sources[chart.triangles[i]] != at.triangle) continue;
        const FlatTriangle& t = chart.texels[i];
        const Rgb seen =
            look_up(map.irradiances[size_t(chart.page)], t[0] * (1 - at.u - at.v) + t[1] * at.u + t[2] * at.v);
        const double expected = double(luminance(solution.vertex_irradiances[v].v));
        error += std::fabs(double(luminance(seen)) - expected), level += expected, ++compared;
      }
    }
  }
  EXPECT_EQ(compared, solution.mesh.positions.size());
  EXPECT_LT(error, 0.004 * level);
}

TEST(Lightmap, EveryCornerReadsLightOfItsOwnChart) {
  const Scene scene = room({3, 2.5f, 3}, Rgb(0.6f), Rgb(10));
  const Lightmap map = make_lightmap(scene, solved(scene, 0.3), of_solution(0.05));
  for (const PlacedChart& chart : map.layout.charts)
    for (const FlatTriangle& t : chart.texels)
      for (const Vec2 p : t) {
        EXPECT_TRUE(p.x - 0.5f >= float(chart.x) && p.x + 0.5f <= float(chart.x + chart.width));
        EXPECT_GT(luminance(look_up(map.irradiances[size_t(chart.page)], p)), 0) << chart.surface;
      }
}

/// Closed form: a disc-like small lamp far above is a point; here one point lamp above a floor.
TEST(Lightmap, DirectLightByRaysIsInverseSquareAndShadowsAreSharp) {
  Scene scene;
  add_quad(scene, {-2, 0, 2}, Vec3(4, 0, 0), Vec3(0, 0, -4), Rgb(0.5f));
  add_quad(scene, {-0.5f, 1, -0.5f}, Vec3(1, 0, 0), Vec3(0, 0, 1), Rgb(0.5f));  // a screen, half way; its front below
  scene.lights.push_back({"lamp", PointLight{{0, 2, 0}, Intensity(Rgb(100))}, -1});
  const Solution solution = solved(scene, 0.5);
  LightmapOptions options;
  options.texel_size = 0.02;
  const Lightmap map = make_lightmap(scene, solution, options);
  size_t checked = 0;
  for (const LightmapTexel& t : map.texels) {
    const PlacedChart& chart = map.layout.charts[t.chart];
    const LightmapSurface& surface = map.layout.surfaces[chart.surface];
    if (surface.instance != 0) continue;
    Point3 x(0);
    const float w[3] = {1 - t.u - t.v, t.u, t.v};
    for (size_t k = 0; k < 3; ++k) x += w[k] * surface.corners[chart.triangles[t.triangle]][k];
    const float edge = std::max(std::fabs(x.x), std::fabs(x.z)) - 1;  // the shadow is a square of 2 m
    if (std::fabs(edge) < 0.1f || std::max(std::fabs(x.x), std::fabs(x.z)) > 1.95f) continue;
    const double lux = double(map.irradiances[0].rgb(int(t.x), int(t.y)).g);
    const double d2 = double(squared_length(x - Point3(0, 2, 0)));
    const double direct = edge < 0 ? 0 : 100 * 2 / std::pow(d2, 1.5);
    const double reflected = 1.5;  // lx: what comes back from the screen's lower side is less
    EXPECT_GE(lux, direct * 0.995);
    EXPECT_LE(lux, direct * 1.005 + reflected);
    ++checked;
  }
  EXPECT_GT(checked, 20000u);
}

TEST(Lightmap, FinalGatherAgreesWithTheSolution) {
  const Scene scene = furnished();
  const Solution solution = solved(scene);
  const Lightmap smooth = make_lightmap(scene, solution, of_solution(0.1));
  LightmapOptions options = of_solution(0.1);
  options.gather_samples = 256;
  const Lightmap gathered = make_lightmap(scene, solution, options);
  double a = 0, b = 0, apart = 0;
  for (size_t i = 0; i < smooth.texels.size(); ++i) {
    const LightmapTexel& t = smooth.texels[i];
    const float x = luminance(smooth.irradiances[0].rgb(int(t.x), int(t.y)));
    const float y = luminance(gathered.irradiances[0].rgb(int(t.x), int(t.y)));
    a += double(x), b += double(y), apart += double(std::fabs(x - y));
  }
  EXPECT_NEAR(b / a, 1, 0.02);
  EXPECT_LT(apart / a, 0.06);
}

TEST(Lightmap, BothSidesOfATwoSidedSurface) {
  Scene scene = room({2, 2, 2}, Rgb(0.5f));
  const size_t wall = add_quad(scene, {1, 0, 0}, Vec3(0, 2, 0), Vec3(0, 0, 2), Rgb(0.5f));  // its front towards +x
  scene.materials.back().double_sided = true;
  scene.lights.push_back({"lamp", PointLight{{0.3f, 1, 1}, Intensity(Rgb(100))}, -1});
  const Lightmap map = make_lightmap(scene, solved(scene, 0.2), of_solution(0.05));
  double lux[2] = {0, 0};
  int texels[2] = {0, 0};
  for (const LightmapTexel& t : map.texels) {
    const LightmapSurface& s = map.layout.surfaces[map.layout.charts[t.chart].surface];
    if (s.instance == wall) lux[s.back] += double(map.irradiances[0].rgb(int(t.x), int(t.y)).g), ++texels[s.back];
  }
  ASSERT_GT(texels[0], 0);
  EXPECT_EQ(texels[0], texels[1]);
  EXPECT_LT(lux[0], 0.1 * lux[1]) << "the lamp is behind";
  EXPECT_GT(lux[1] / texels[1], 30);
}

TEST(Lightmap, SeamsOfABallCloseAndShrinkWithTheTexels) {
  Scene scene = room({4, 4, 4}, Rgb(0.5f));
  Mesh ball = test::ball(16, 0.5f);
  ball.material = int(scene.materials.size());
  scene.materials.emplace_back().metallic = 0;
  scene.instances.push_back({.mesh = int(scene.meshes.size()), .to_world = glm::mat4(1)});
  for (Point3& p : ball.positions) p += Vec3(2, 1, 2);
  scene.meshes.push_back(ball);
  scene.lights.push_back({"lamp", PointLight{{1, 3.5f, 1}, Intensity(Rgb(100))}, -1});
  const Solution solution = solved(scene, 0.2);
  double before = 1e30;
  for (const double texel : {0.08, 0.02}) {
    const Lightmap map = make_lightmap(scene, solution, of_solution(texel));
    EXPECT_GT(map.seams.samples, 100u);
    EXPECT_LT(map.seams.before, 0.5 * before) << "of first order in the texel";
    EXPECT_LT(map.seams.after, 0.1 * map.seams.before);
    before = map.seams.before;
  }
}

TEST(Lightmap, SeamsAcrossObjects) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, Vec3(1, 0, 0), Vec3(0, 0, -1), Rgb(0.5f));
  add_quad(scene, {1, 0, 0}, Vec3(1.37f, 0, 0), Vec3(0, 0, -1), Rgb(0.5f));  // goes on where the first ends
  scene.lights.push_back({"lamp", PointLight{{0.8f, 0.7f, -0.4f}, Intensity(Rgb(100))}, -1});
  const Lightmap map = make_lightmap(scene, solved(scene, 0.25), of_solution(0.07));
  EXPECT_GT(map.seams.samples, 10u);
  EXPECT_LT(map.seams.after, 0.005);
}

TEST(Lightmap, TheSameForAnyNumberOfThreads) {
  const Scene scene = furnished();
  const Solution solution = solved(scene, 0.3);
  LightmapOptions options;
  options.texel_size = 0.05, options.gather_samples = 4;
  std::vector<std::vector<float>> pixels;
  for (const int threads : {1, 2, 0}) {
    set_thread_count(threads);
    pixels.push_back(make_lightmap(scene, solution, options).irradiances[0].pixels);
  }
  EXPECT_EQ(pixels[0], pixels[1]);
  EXPECT_EQ(pixels[0], pixels[2]);
}

TEST(Lightmap, NoiseIsSmoothedWhereThereIsSome) {
  const Scene scene = furnished();
  const Solution solution = solved(scene, 0.2);
  LightmapOptions few, many;
  few.texel_size = many.texel_size = 0.06;
  few.direct_samples = 16, many.direct_samples = 256;
  const Image noisy = make_lightmap(scene, solution, few).irradiances[0];
  const Lightmap good = make_lightmap(scene, solution, many);
  double square = 0, level = 0;
  for (const LightmapTexel& t : good.texels) {
    const double truth = double(luminance(good.irradiances[0].rgb(int(t.x), int(t.y))));
    const double d = double(luminance(noisy.rgb(int(t.x), int(t.y)))) - truth;
    square += d * d, level += truth;
  }
  const auto n = double(good.texels.size());
  EXPECT_LT(std::sqrt(square / n), 0.03 * level / n);
}

/// The floor goes on below the box; what the box hides must not darken what lies next to it.
TEST(Lightmap, ContactsHaveNoDarkLine) {
  Scene scene = furnished();
  LightmapOptions options;
  options.texel_size = 0.037;  // the box stands between texels
  const Lightmap map = make_lightmap(scene, solved(scene, 0.1), options);
  std::vector<double> inside, beside, deep;
  for (const LightmapTexel& t : map.texels) {
    const PlacedChart& chart = map.layout.charts[t.chart];
    const LightmapSurface& surface = map.layout.surfaces[chart.surface];
    if (surface.instance != 0) continue;
    Point3 x(0);
    const float w[3] = {1 - t.u - t.v, t.u, t.v};
    for (size_t k = 0; k < 3; ++k) x += w[k] * surface.corners[chart.triangles[t.triangle]][k];
    if (x.z < 1.2f || x.z > 1.6f) continue;
    const double lux = double(map.irradiances[0].rgb(int(t.x), int(t.y)).g);
    if (x.x > 1.3f && x.x < 1.5f) deep.push_back(lux);
    if (x.x > 1.0f && x.x < 1.05f) inside.push_back(lux);
    if (x.x > 0.93f && x.x < 0.99f) beside.push_back(lux);
  }
  ASSERT_FALSE(inside.empty() || beside.empty());
  const auto mean = [](const std::vector<double>& v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / double(v.size());
  };
  EXPECT_NEAR(mean(inside) / mean(beside), 1, 0.15);
  EXPECT_NEAR(mean(deep) / mean(beside), 1, 0.3) << "filled to the middle, though nobody sees it";
}

TEST(Lightmap, AnotherScenesSolutionIsRefused) {
  const Scene scene = furnished();
  const Solution solution = solved(scene, 0.5);
  Scene other;
  add_quad(other, Point3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Rgb(0.5f));
  EXPECT_THROW(make_lightmap(other, solution), Error);
}

TEST(LightmappedScene, CoordinatesLeadToTheCharts) {
  Scene scene = furnished();
  scene.materials[0].double_sided = true;
  const Lightmap map = make_lightmap(scene, solved(scene, 0.5), of_solution(0.05));
  const LightmappedScene mapped = lightmapped_scene(scene, map);
  ASSERT_EQ(mapped.scene.instances.size(), map.layout.surfaces.size());
  size_t triangles = 0;
  for (const Mesh& mesh : mapped.scene.meshes) {
    ASSERT_EQ(mesh.uv[1].size(), mesh.positions.size());
    for (const Vec2 uv : mesh.uv[1]) EXPECT_TRUE(uv.x > 0 && uv.x < 1 && uv.y > 0 && uv.y < 1);
    triangles += mesh.triangles.size();
  }
  EXPECT_EQ(triangles, 2 * map.layout.surfaces.size());
  EXPECT_EQ(std::count(mapped.backs.begin(), mapped.backs.end(), 1), 1);
}

TEST(LightmappedScene, TexturesOnTheSecondSetMoveToTheFirst) {
  Scene scene = furnished();
  scene.images.emplace_back();
  scene.images[0].pixels = Image(1, 1, 4, 0.5f);
  scene.materials[0].base_texture = {.image = 0, .uv_set = 1};
  scene.meshes[0].uv[1] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};  // repeats: of no use for a lightmap
  const Lightmap map = make_lightmap(scene, solved(scene, 0.5), of_solution(0.05));
  const LightmappedScene mapped = lightmapped_scene(scene, map);
  EXPECT_EQ(mapped.scene.materials[0].base_texture.uv_set, 0);
  EXPECT_EQ(mapped.scene.meshes[0].uv[0][2], Vec2(3, 3));
  scene.materials[0].normal_texture = {.image = 0, .uv_set = 0};
  EXPECT_THROW(lightmapped_scene(scene, map), Error);
}

}  // namespace
}  // namespace aktina
