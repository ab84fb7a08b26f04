#include "aktina/radiosity/lightmap/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "radiosity/lightmap/surfaces.h"

namespace aktina {
namespace {

using testing::HasSubstr;

Mesh unit_square(std::vector<Vec2> given = {}) {
  Scene scene;
  add_quad(scene, Point3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Rgb(0.5f));
  Mesh mesh = scene.meshes[0];
  mesh.uv[1] = std::move(given);
  return mesh;
}

LightmapLayout layout_of(const std::vector<Mesh>& meshes, const LightmapOptions& options) {
  std::vector<LightmapSurface> surfaces;
  for (const Mesh& mesh : meshes) surfaces.push_back(test::surface_of_mesh(mesh));
  return make_layout(std::move(surfaces), options);
}

TEST(Layout, MiddlesOfTexelsLieOnTheEdges) {
  LightmapOptions options;
  options.texel_size = 0.1, options.padding = 3;
  const LightmapLayout layout = layout_of({unit_square()}, options);
  ASSERT_EQ(layout.charts.size(), 1u);
  EXPECT_EQ(layout.charts[0].width, 11 + 6) << "ten steps, eleven middles, and the padding";
  Vec2 low(kInfinity), high(-kInfinity);
  for (const FlatTriangle& t : layout.charts[0].texels)
    for (const Vec2 p : t) low = glm::min(low, p), high = glm::max(high, p);
  EXPECT_NEAR(low.x, 3.5f, 1e-4f);
  EXPECT_NEAR(high.x, 13.5f, 1e-4f);
}

TEST(Layout, WithoutATexelSizeThePageIsUsed) {
  LightmapOptions options;
  options.size = 256;
  const LightmapLayout layout = layout_of({unit_square(), unit_square(), unit_square()}, options);
  ASSERT_EQ(layout.pages.size(), 1u);
  EXPECT_EQ(layout.pages[0].width, 256);
  double used = 0;
  for (const PlacedChart& c : layout.charts) used += double(c.width) * double(c.height);
  EXPECT_GT(used / (256 * 256), 0.6) << "three squares of equal size: at best three quarters";
}

TEST(Layout, WhatDoesNotFitOnePageTakesMore) {
  LightmapOptions options;
  options.size = 64, options.texel_size = 1.0 / 40;
  const LightmapLayout layout = layout_of(std::vector<Mesh>(3, unit_square()), options);
  EXPECT_EQ(layout.pages.size(), 3u);
}

TEST(Layout, TooFineIsRefusedWithWhatWouldFit) {
  LightmapOptions options;
  options.size = 64;
  for (const double texel : {0.01, 1e-9, 1e-300}) {
    options.texel_size = texel;
    try {
      layout_of({unit_square()}, options);
      ADD_FAILURE() << texel;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), Code::limit);
      ASSERT_THAT(e.hint(), HasSubstr("--texel-size 0.0"));
      const double fits = std::stod(e.hint().substr(e.hint().find("0.0")));
      options.texel_size = fits;
      EXPECT_EQ(layout_of({unit_square()}, options).pages.size(), 1u) << "what it says fits";
    }
  }
}

TEST(Layout, MoreChartsThanAPageHasRoomFor) {
  LightmapOptions options;
  options.size = 16;
  try {
    layout_of(std::vector<Mesh>(40, unit_square()), options);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), Code::limit);
    EXPECT_THAT(e.what(), HasSubstr("40 charts"));
    EXPECT_THAT(e.hint(), HasSubstr("--lightmap-size"));
  }
}

TEST(Layout, OptionsOutOfRange) {
  LightmapOptions options;
  options.size = 4;
  EXPECT_THROW(layout_of({unit_square()}, options), Error);
  options = {}, options.texel_size = -1;
  EXPECT_THROW(layout_of({unit_square()}, options), Error);
  options = {}, options.padding = 1000;
  EXPECT_THROW(layout_of({unit_square()}, options), Error);
  EXPECT_THROW(make_layout({}, {}), Error);
}

// Coordinates of the file.

const std::vector<Vec2> kLeftHalf = {{0, 0}, {0.5f, 0}, {0.5f, 1}, {0, 1}};
const std::vector<Vec2> kRightHalf = {{0.5f, 0}, {1, 0}, {1, 1}, {0.5f, 1}};

TEST(GivenCoordinates, OfOnePageStayAsTheyAre) {
  LightmapOptions options;
  options.size = 100;
  const LightmapLayout layout = layout_of({unit_square(kLeftHalf), unit_square(kRightHalf)}, options);
  EXPECT_EQ(layout.kept, 2u);
  EXPECT_TRUE(layout.warnings.empty());
  ASSERT_EQ(layout.charts.size(), 2u);
  EXPECT_EQ(layout.charts[1].texels[0][0], Vec2(50, 0));
  EXPECT_EQ(layout.charts[1].texels[0][2], Vec2(100, 100));
  EXPECT_NEAR(layout.texel_size, std::sqrt(2.0) / 100, 1e-6);
}

TEST(GivenCoordinates, OfSurfacesThatUseTheSamePlaceAreMoved) {
  const LightmapLayout layout = layout_of({unit_square(kLeftHalf), unit_square(kLeftHalf)}, {});
  EXPECT_EQ(layout.kept, 2u);
  ASSERT_EQ(layout.charts.size(), 2u);
  const PlacedChart &a = layout.charts[0], &b = layout.charts[1];
  EXPECT_TRUE(a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y);
  const Vec2 across = a.texels[0][1] - a.texels[0][0], down = a.texels[0][2] - a.texels[0][1];
  EXPECT_NEAR(length(down), 2 * length(across), 0.01f) << "the shape is the file's: half as wide as high";
}

TEST(GivenCoordinates, MirroredOnesCanBeUsed) {
  const LightmapLayout layout = layout_of({unit_square({{1, 0}, {0, 0}, {0, 1}, {1, 1}})}, {});
  EXPECT_EQ(layout.kept, 1u);
}

TEST(GivenCoordinates, OthersAreReplacedAndCounted) {
  const std::vector<Vec2> outside = {{0, 0}, {2, 0}, {2, 1}, {0, 1}}, flat = {{0, 0}, {1, 0}, {1, 0}, {0, 0}},
                          upon = {{0, 0}, {1, 0}, {0.9f, 0.9f}, {1, 0.1f}}, none = {{0, 0}, {NAN, 0}, {1, 1}, {0, 1}};
  for (const auto& given : {outside, flat, upon, none}) {
    const LightmapLayout layout = layout_of({unit_square(given)}, {});
    EXPECT_EQ(layout.kept, 0u);
    ASSERT_EQ(layout.warnings.items().size(), 1u);
    EXPECT_THAT(layout.warnings.items()[0].text, HasSubstr("charts were made instead"));
  }
}

TEST(GivenCoordinates, CanBeLeftAside) {
  LightmapOptions options;
  options.keep_uv = false;
  EXPECT_EQ(layout_of({unit_square(kLeftHalf)}, options).kept, 0u);
}

}  // namespace
}  // namespace aktina
