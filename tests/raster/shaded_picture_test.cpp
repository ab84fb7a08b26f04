// What the rasterizer's pictures show: shading methods against closed forms, against each other and against the
// illumination equation itself.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/illumination/illuminate.h"
#include "aktina/raster/rasterize.h"
#include "aktina/raster/shading/shading_method.h"
#include "aktina/scene/scene_lights.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

using test::add_material;
using test::add_mesh;
using test::quad;

const ClassicMaterial kPlastic{.ka = Rgb(0.2f), .kd = {0.6f, 0.45f, 0.3f}, .ks = Rgb(0.4f), .exponent = 20};

Scene bumpy_scene(int lamps) {
  Scene scene;
  add_mesh(scene, test::bumpy_sphere(36, 20), add_material(scene, kPlastic));
  for (int i = 0; i < lamps; ++i) {
    const auto angle = float(i);
    scene.lights.push_back(
        {"lamp", PointLight{{4 * std::cos(angle), 4 * std::sin(angle), 3}, Intensity(Rgb(40.0f / float(lamps))), {}},
         -1});
  }
  scene.ambient = Rgb(0.3f);
  scene.cameras.push_back(look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.8f));
  return scene;
}

double largest_difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  double largest = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, std::abs(double(a.pixels[i]) - double(b.pixels[i])));
  return largest;
}

Image picture(const Scene& scene, int width, int height, const RasterOptions& options) {
  return rasterize(scene, scene.cameras[0], width, height, options).layers[0].image;
}

TEST(ShadedPicture, PhongIsTheIlluminationEquationAtEachPixel) {
  for (const int lamps : {1, 25})
    for (const char* model : {"lambert", "phong", "blinn_phong"}) {
      const Scene scene = bumpy_scene(lamps);
      const LayeredImage out = rasterize(scene, scene.cameras[0], 70, 50,
                                         {.illumination = model, .normal = true, .position = true, .depth = true});
      const SceneLights lights = scene_lights(scene);
      const IlluminationModel illumination = make_method(illumination_models(), "illumination", model);
      int seen = 0;
      for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 70; ++x) {
          if (!std::isfinite(*out.find("Z")->at(x, y))) continue;
          ++seen;
          const float *p = out.find("P")->at(x, y), *n = out.find("N")->at(x, y);
          const Point3 at(p[0], p[1], p[2]);
          const Rgb exact = illuminate(illumination, surface_of(scene.materials[0]), lights.lights, lights.ambient, at,
                                       {n[0], n[1], n[2]}, normalize(scene.cameras[0].position() - at))
                                .total();
          for (int k = 0; k < 3; ++k) ASSERT_NEAR(out.layers[0].image.rgb(x, y)[k], exact[k], 2e-4 * (1 + exact[k]));
        }
      EXPECT_GT(seen, 700);
    }
}

TEST(ShadedPicture, LayersDoNotChangeThePicture) {
  const Scene scene = bumpy_scene(3);
  for (const char* shading : {"flat", "gouraud", "phong", "gouraud:perspective=1"}) {
    const Image plain = picture(scene, 90, 90, {.shading = shading});
    const Image layered = picture(scene, 90, 90, {.shading = shading, .albedo = true, .normal = true});
    EXPECT_LT(largest_difference(plain, layered), 1e-4) << shading;  // immediate and deferred give the same
  }
}

TEST(ShadedPicture, TheSameBytesForAnyNumberOfThreads) {
  const Scene scene = test::cornell_box();
  for (const char* shading : {"flat", "gouraud", "phong"}) {
    const auto draw = [&](int threads) {
      set_thread_count(threads);
      return rasterize(scene, scene.cameras[0], 150, 200, {.shading = shading, .samples = 4, .normal = true});
    };
    const LayeredImage one = draw(1), two = draw(2), five = draw(5);
    set_thread_count(0);
    for (size_t l = 0; l < one.layers.size(); ++l) {
      EXPECT_EQ(one.layers[l].image.pixels, two.layers[l].image.pixels);
      EXPECT_EQ(one.layers[l].image.pixels, five.layers[l].image.pixels);
    }
  }
}

TEST(ShadedPicture, EveryInstructionSetGivesTheSamePicture) {
  const Scene scene = bumpy_scene(3);
  for (const char* shading : {"flat", "gouraud", "phong"}) {
    const Image best = picture(scene, 80, 60, {.shading = shading});
    for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      const Image other = picture(scene, 80, 60, {.shading = shading});
      int different =
          0;  // a vertex may fall on another of the 1/256 pixels, and a pixel on an edge change its triangle
      for (size_t i = 0; i < best.pixels.size(); ++i) different += std::abs(best.pixels[i] - other.pixels[i]) > 0.02f;
      EXPECT_LE(different, 20) << shading << ' ' << hwy::TargetName(target);
    }
    hwy::SetSupportedTargetsForTest(0);
  }
}

TEST(ShadedPicture, MethodsAgreeOnAPolyhedronWithLightAndViewerFarAway) {
  Scene scene;
  const int matt = add_material(scene, kPlastic);
  add_mesh(scene, quad({-1, -1, 0}, {1, -1, 0.5f}, {1, 1, 0.5f}, {-1, 1, 0}), matt);
  add_mesh(scene, quad({-1, -1, 0}, {-1, -2, -1}, {1, -2, -0.5f}, {1, -1, 0.5f}), matt);
  scene.lights.push_back({"sun", DirectionalLight{normalize(Vec3(-0.3f, -0.4f, -1)), Irradiance(Rgb(3))}, -1});
  Camera camera = look_at({0.5f, 0.2f, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  camera.kind = Camera::Kind::orthographic;
  camera.half_height = 2.5f;
  scene.cameras.push_back(camera);
  const Image flat = picture(scene, 64, 64, {.shading = "flat"});
  EXPECT_LT(largest_difference(flat, picture(scene, 64, 64, {.shading = "gouraud"})), 1e-5);
  EXPECT_LT(largest_difference(flat, picture(scene, 64, 64, {.shading = "phong"})), 1e-5);
  EXPECT_GT(*std::max_element(flat.pixels.begin(), flat.pixels.end()), 0.3f);
}

/// Unlit square from (-1, -1) to (1, 1) at z = 0, colours x and y and 1 at its vertices, seen obliquely.
Scene coloured_square(float scale) {
  Scene scene;
  scene.materials.emplace_back();
  scene.materials[0].unlit = true;
  Mesh mesh = quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  for (const Point3 p : mesh.positions) mesh.colours.push_back(Vec4(scale * (p.x + 1), scale * (p.y + 1), scale, 1));
  add_mesh(scene, mesh, 0);
  scene.cameras.push_back(look_at({1.5f, -1.8f, 1}, {0, 0, 0}, {0, 0, 1}, 0.9f));
  return scene;
}

TEST(ShadedPicture, UnlitColoursAreLinearOnTheSurface) {
  const Scene scene = coloured_square(10);
  const LayeredImage out = rasterize(scene, scene.cameras[0], 100, 80, {.position = true, .depth = true});
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x) {
      const CameraRay ray = camera_ray(scene.cameras[0], float(x) + 0.5f, float(y) + 0.5f, 100, 80);
      const Point3 hit = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
      if (!std::isfinite(*out.find("Z")->at(x, y))) continue;
      const float* p = out.find("P")->at(x, y);
      const double pixel = 2e-2 / 256 * 4;  // m on the square that a sub-pixel is, at most
      EXPECT_NEAR(p[0], hit.x, pixel);
      EXPECT_NEAR(p[1], hit.y, pixel);
      EXPECT_NEAR(out.layers[0].image.rgb(x, y).r, 10 * (hit.x + 1), 20 * pixel);
      EXPECT_NEAR(out.layers[0].image.rgb(x, y).g, 10 * (hit.y + 1), 20 * pixel);
      EXPECT_NEAR(out.layers[0].image.rgb(x, y).b, 10, 1e-4);
    }
}

TEST(ShadedPicture, ColoursCutAtTheNearPlaneStayTheSame) {
  Scene scene = coloured_square(1);
  scene.cameras[0] = look_at({0, -0.5f, 0.3f}, {0.2f, 0.5f, 0}, {0, 0, 1}, 1.2f);  // the square passes under the eye
  scene.cameras[0].near = 0.2f;
  const LayeredImage out = rasterize(scene, scene.cameras[0], 80, 80, {.depth = true});
  int seen = 0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      if (!std::isfinite(*out.find("Z")->at(x, y))) continue;
      const CameraRay ray = camera_ray(scene.cameras[0], float(x) + 0.5f, float(y) + 0.5f, 80, 80);
      const Point3 hit = ray.origin - ray.direction * (ray.origin.z / ray.direction.z);
      EXPECT_NEAR(out.layers[0].image.rgb(x, y).r, hit.x + 1, 2e-3);
      EXPECT_NEAR(out.layers[0].image.rgb(x, y).g, hit.y + 1, 2e-3);
      ++seen;
    }
  EXPECT_GT(seen, 2000);
}

TEST(ShadedPicture, GouraudIsLinearOnTheScreen) {
  Scene scene;
  add_mesh(scene, quad({-9, -9, 0}, {9, -9, -3}, {9, 9, -3}, {-9, 9, 0}), add_material(scene, kPlastic));
  scene.meshes[0].triangles = {{0, 1, 2}};
  scene.lights.push_back({"lamp", PointLight{{0, 1, 2}, Intensity(Rgb(300)), {}}, -1});
  scene.cameras.push_back(look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.9f));
  const Image p = picture(scene, 60, 60, {.shading = "gouraud"});
  int checked = 0;
  for (int y = 30; y < 60; ++y)
    for (int x = 31; x < 59; ++x) {
      if (p.rgb(x - 1, y).g == 0 || p.rgb(x + 1, y).g == 0) continue;
      EXPECT_NEAR(p.rgb(x - 1, y).g + p.rgb(x + 1, y).g, 2 * p.rgb(x, y).g, 2e-5 * p.rgb(x, y).g + 1e-5);
      ++checked;
    }
  EXPECT_GT(checked, 200);
}

Scene textured_square(Filter filter) {
  Scene scene;
  TextureImage image;
  Bitmap bitmap{4, 4, 3, true, {}};
  for (int i = 0; i < 48; ++i) bitmap.pixels.push_back(uint8_t(i * 37 % 256));
  image.pixels = bitmap;
  scene.images.push_back(image);
  scene.materials.emplace_back();
  scene.materials[0].base_texture.image = 0;
  scene.materials[0].base_texture.filter = filter;
  scene.materials[0].unlit = true;
  add_mesh(scene, quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}), 0);
  Camera camera = look_at({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 1);
  camera.kind = Camera::Kind::orthographic;
  scene.cameras.push_back(camera);
  return scene;
}

TEST(ShadedPicture, TexturesAreWhatLookUpSays) {
  for (const Filter filter : {Filter::bilinear, Filter::nearest}) {
    const Scene scene = textured_square(filter);
    constexpr int kSize = 44;
    const Image p = picture(scene, kSize, kSize, {});
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const Vec2 uv((float(x) + 0.5f) / kSize, (float(y) + 0.5f) / kSize);
        const Vec4 exact = look_up(scene.images[0], scene.materials[0].base_texture, uv, true);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(p.rgb(x, y)[k], exact[k], 1e-4);
      }
  }
}

TEST(ShadedPicture, EveryModelReadsTextures) {
  Scene scene = textured_square(Filter::nearest);
  Material& material = scene.materials[0];
  material.unlit = false, material.metallic = 0.7f, material.roughness = 0.6f;
  const Vec3 towards = normalize(Vec3(0.3f, 0.2f, 1));
  scene.lights.push_back({"sun", DirectionalLight{-towards, Irradiance(Rgb(3))}, -1});
  for (const auto* row : illumination_models()) {
    const Image p = picture(scene, 44, 44, {.illumination = std::string(row->info.id)});
    for (int y = 5; y < 44; y += 11)
      for (int x = 5; x < 44; x += 11) {
        const Vec2 uv[2] = {{(float(x) + 0.5f) / 44, (float(y) + 0.5f) / 44}, {0, 0}};
        const Surface s = evaluate(scene, material, uv, Vec4(1)).surface;
        const Rgb exact =
            brdf_cosine(row->make(ParamSet(row->info)), s, {0, 0, 1}, towards, {0, 0, 1}).total() * Rgb(3);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(p.rgb(x, y)[k], exact[k], 1e-4f) << row->info.id;
      }
  }
}

TEST(ShadedPicture, EveryMethodShowsMetalWhereATextureSaysSo) {
  // On a plane, lit and seen from far away, all methods are the model at each pixel; the material itself is a metal.
  Scene scene = textured_square(Filter::nearest);
  TextureImage image;
  image.pixels = Bitmap{2, 1, 3, true, {0, 255, 255, 0, 255, 40}};  // metal; hardly any
  scene.images.push_back(image);
  Material& material = scene.materials[0];
  material.unlit = false, material.roughness = 0.6f;
  material.metallic_roughness_texture.image = 1, material.metallic_roughness_texture.filter = Filter::nearest;
  scene.ambient = Rgb(0.2f);
  scene.lights.push_back({"sun", DirectionalLight{normalize(Vec3(-0.2f, 0.1f, -1)), Irradiance(Rgb(3))}, -1});
  const Image exact = picture(scene, 44, 44, {.shading = "phong"});
  for (const ShadingRow* row : shading_methods()) {
    const std::string method(row->info.id);
    const Image drawn = picture(scene, 44, 44, {.shading = method});
    const float within = method == "angular_power" ? 0.1f : method == "vlasic" ? 0.01f : 1e-3f;  // their own powers
    EXPECT_LT(largest_difference(drawn, exact), within) << method;
  }
}

TEST(ShadedPicture, ABaseTextureMultipliesDiffuseLight) {
  Scene scene = textured_square(Filter::nearest);
  scene.materials[0].unlit = false;
  scene.materials[0].classic = kPlastic;
  scene.lights.push_back({"sun", DirectionalLight{{0, 0, -1}, Irradiance(Rgb(3))}, -1});
  Scene plain = scene;
  plain.materials[0].base_texture = {};
  plain.materials[0].classic->ks = Rgb(0);
  for (const char* shading : {"flat", "gouraud", "phong"}) {
    const Image textured = picture(scene, 44, 44, {.shading = shading, .illumination = "lambert"});
    const Image matt = picture(plain, 44, 44, {.shading = shading, .illumination = "lambert"});
    for (int y = 5; y < 44; y += 11)
      for (int x = 5; x < 44; x += 11) {
        const Vec2 uv((float(x) + 0.5f) / 44, (float(y) + 0.5f) / 44);
        const Vec4 texel = look_up(scene.images[0], scene.materials[0].base_texture, uv, true);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(textured.rgb(x, y)[k], texel[k] * matt.rgb(x, y)[k], 1e-4) << shading;
      }
  }
}

/// Two unlit squares, the nearer one of alpha 0.25, before a background.
Scene veiled_square(AlphaMode mode, float alpha) {
  Scene scene;
  scene.materials.resize(2);
  for (Material& m : scene.materials) m.unlit = true;
  scene.materials[0].base_colour = Rgb(1);
  scene.materials[1].base_colour = {0, 1, 0};
  scene.materials[1].alpha = alpha, scene.materials[1].alpha_mode = mode;
  add_mesh(scene, quad({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}), 1);  // first in the list, nearer
  add_mesh(scene, quad({-1, -1, 0.5f}, {0, -1, 0.5f}, {0, 1, 0.5f}, {-1, 1, 0.5f}), 1);
  add_mesh(scene, quad({-1, -1, 0}, {1, -1, 0}, {1, 0, 0}, {-1, 0, 0}), 0);
  scene.background = Radiance(Rgb(0.5f));
  Camera camera = look_at({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 1);
  camera.kind = Camera::Kind::orthographic;
  scene.cameras.push_back(camera);
  return scene;
}

TEST(ShadedPicture, BlendedSurfacesAreDrawnFromBackToFront) {
  const Image p = picture(veiled_square(AlphaMode::blend, 0.25f), 32, 32, {});
  EXPECT_NEAR(p.rgb(24, 24).r, 0.75, 1e-5);  // one veil over white
  EXPECT_NEAR(p.rgb(24, 24).g, 1, 1e-5);
  EXPECT_NEAR(p.rgb(8, 24).r, 0.5625, 1e-5);  // two veils
  EXPECT_NEAR(p.rgb(24, 8).r, 0.375, 1e-5);   // over the background
  EXPECT_NEAR(p.rgb(24, 8).g, 0.625, 1e-5);
}

TEST(ShadedPicture, MasksCutOut) {
  EXPECT_EQ(picture(veiled_square(AlphaMode::mask, 0.25f), 32, 32, {}).rgb(24, 24), Rgb(1));
  EXPECT_EQ(picture(veiled_square(AlphaMode::mask, 0.75f), 32, 32, {}).rgb(24, 24), Rgb(0, 1, 0));
}

TEST(ShadedPicture, NormalMapsBendNormals) {
  Scene scene = textured_square(Filter::nearest);
  scene.images[0].pixels = Bitmap{1, 1, 3, true, {255, 128, 128}};  // along u: +x
  scene.materials[0] = material_of(kPlastic);
  scene.materials[0].normal_texture.image = 0;
  const LayeredImage out = rasterize(scene, scene.cameras[0], 8, 8, {.normal = true});
  EXPECT_NEAR(out.find("N")->at(4, 4)[0], 1, 0.01);
  scene.images[0].pixels = Bitmap{1, 1, 3, true, {128, 255, 128}};  // against v, which runs down: +y
  EXPECT_NEAR(rasterize(scene, scene.cameras[0], 8, 8, {.normal = true}).find("N")->at(4, 4)[1], 1, 0.01);
}

TEST(ShadedPicture, MeshesInsideOutAreLitFromBothSidesAlike) {
  Scene scene = bumpy_scene(2);
  const Image outward = picture(scene, 60, 60, {});
  for (auto& t : scene.meshes[0].triangles) std::swap(t[1], t[2]);
  for (Vec3& n : scene.meshes[0].normals) n = -n;
  EXPECT_LT(largest_difference(outward, picture(scene, 60, 60, {})), 1e-4);
  const Image culled = picture(scene, 60, 60, {.cull_back_faces = true});
  EXPECT_NE(culled.pixels, outward.pixels);  // what is left is the far side, seen through the near one
}

TEST(ShadedPicture, MirroredInstancesKeepTheirFronts) {
  Scene scene = bumpy_scene(2);
  scene.instances[0].to_world[0].x = -1;
  const Image both = picture(scene, 60, 60, {}), fronts = picture(scene, 60, 60, {.cull_back_faces = true});
  EXPECT_EQ(both.pixels, fronts.pixels);
}

TEST(ShadedPicture, SamplesAverage) {
  const Scene scene = bumpy_scene(2);
  const Image one = picture(scene, 64, 48, {}), four = picture(scene, 32, 24, {.samples = 4});
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 32; ++x) {
      const Rgb mean = (one.rgb(2 * x, 2 * y) + one.rgb(2 * x + 1, 2 * y) + one.rgb(2 * x, 2 * y + 1) +
                        one.rgb(2 * x + 1, 2 * y + 1)) *
                       0.25f;
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(four.rgb(x, y)[k], mean[k], 1e-5);
    }
}

TEST(ShadedPicture, TheSkyStandsBehind) {
  Scene scene = bumpy_scene(1);
  scene.environment.radiance = Image(8, 4, 3);
  for (size_t i = 0; i < scene.environment.radiance.pixels.size(); ++i)
    scene.environment.radiance.pixels[i] = float(i % 7);
  scene.environment.colour = Radiance(Rgb(2));
  const CameraRay ray = camera_ray(scene.cameras[0], 0.5f, 0.5f, 40, 30);
  EXPECT_EQ(picture(scene, 40, 30, {}).rgb(0, 0), radiance(scene.environment, ray.direction).v);
}

TEST(ShadedPicture, EmissionIsAddedOnTheFrontOnly) {
  Scene scene = bumpy_scene(0);
  scene.materials[0].emission = Radiance({1, 2, 3});
  for (const char* shading : {"flat", "gouraud", "phong"}) {
    const Rgb c = picture(scene, 9, 9, {.shading = shading}).rgb(4, 4);
    EXPECT_GE(c.r, 1);
    EXPECT_GE(c.b, 3);
  }
  scene.cameras[0] = look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 1);  // from inside
  scene.ambient = Rgb(0);
  EXPECT_LT(picture(scene, 9, 9, {.shading = "phong", .illumination = "lambert"}).rgb(4, 4).b, 1);
}

TEST(ShadedPicture, ARasterizerDrawsOneViewAfterTheOther) {
  const Scene scene = test::cornell_box();
  Rasterizer rasterizer(scene, {.normal = true});
  LayeredImage out;
  Camera other = look_at({0.3f, 0.5f, 3}, {0, 1, 0}, {0, 1, 0}, 0.9f);
  rasterizer.draw(other, 70, 30, out);
  rasterizer.draw(scene.cameras[0], 50, 60, out);
  const LayeredImage fresh = rasterize(scene, scene.cameras[0], 50, 60, {.normal = true});
  ASSERT_EQ(out.layers.size(), 2U);
  for (size_t l = 0; l < 2; ++l) EXPECT_EQ(out.layers[l].image.pixels, fresh.layers[l].image.pixels);
}

TEST(ShadedPicture, StopsWhenAsked) {
  const Scene scene = bumpy_scene(1);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(rasterize(scene, scene.cameras[0], 50, 50, {}, &progress), Error);
}

}  // namespace
}  // namespace aktina
