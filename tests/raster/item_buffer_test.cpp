#include "aktina/raster/item_buffer.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <random>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/raster/vertex_stage.h"
#include "raster/scenes.h"

namespace aktina {
namespace {

using Triangle = std::array<uint32_t, 3>;

/// Looks along -z; one unit is one pixel, (0, 0) the upper left corner of the picture, y down.
Camera pixel_camera(int size) {
  Camera camera;
  camera.kind = Camera::Kind::orthographic;
  camera.half_height = float(size) / 2;
  camera.to_world =
      Mat4(Vec4(1, 0, 0, 0), Vec4(0, -1, 0, 0), Vec4(0, 0, -1, 0), Vec4(float(size) / 2, float(size) / 2, -10, 1));
  return camera;
}

/// The readable form: every pixel against every triangle, in 64-bit integers.
struct Reference {
  ItemBuffer buffer;
  Reference(const View& view, std::span<const Point3> positions, std::span<const Triangle> triangles) {
    buffer.width = view.width(), buffer.height = view.height();
    buffer.item.assign(size_t(view.width()) * size_t(view.height()), ItemBuffer::kNothing);
    buffer.distance.assign(buffer.item.size(), kInfinity);
    ScreenVertices screen;
    screen.resize(positions.size());
    project_vertices(DrawList(positions, triangles), view, 0, positions.size(), screen);
    for (uint32_t t = 0; t < triangles.size(); ++t) {
      ScreenVertex s[3];
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t v = triangles[t][k];
        s[k] = {screen[v].x, screen[v].y, screen[v].depth, 1};
      }
      draw(view, s, t);
    }
  }

  void draw(const View& view, const ScreenVertex (&s)[3], uint32_t item) {
    const int64_t area = int64_t(s[1].x - s[0].x) * (s[2].y - s[0].y) - int64_t(s[2].x - s[0].x) * (s[1].y - s[0].y);
    if (area == 0) return;
    for (int y = 0; y < view.height(); ++y)
      for (int x = 0; x < view.width(); ++x) {
        double weight[3];
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
          const ScreenVertex &from = s[(k + 1) % 3], &to = s[(k + 2) % 3];
          const int64_t sign = area > 0 ? 1 : -1;
          const int64_t a = sign * (from.y - to.y), b = sign * (to.x - from.x);
          const int64_t e = a * (256 * x + 128 - from.x) + b * (256 * y + 128 - from.y);
          inside = inside && (e > 0 || (e == 0 && (a > 0 || (a == 0 && b > 0))));
          weight[k] = double(e) / double(sign * area);
        }
        const double depth =
            weight[0] * double(s[0].depth) + weight[1] * double(s[1].depth) + weight[2] * double(s[2].depth);
        const size_t at = size_t(y * view.width() + x);
        const float distance = view.distance(float(depth));
        if (!inside || !(distance < buffer.distance[at])) continue;
        buffer.item[at] = item, buffer.distance[at] = distance;
      }
  }
};

struct Soup {
  std::vector<Point3> positions;
  std::vector<Triangle> triangles;
  void add(Point3 a, Point3 b, Point3 c) {
    const auto first = uint32_t(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }
  ItemBuffer draw(const Camera& camera, int width, int height, int rows = 0, bool cull = false) const {
    ItemBuffer out;
    ItemRasterizer(positions, triangles).draw(camera, width, height, out, rows, cull);
    return out;
  }
};

/// Triangles in front of look_at({0, 0, 4}, 0), large and small, none beyond a clip plane.
Soup random_soup(int count, uint32_t seed, float size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1.5f, 1.5f), offset(-size, size);
  Soup soup;
  for (int i = 0; i < count; ++i) {
    const Point3 centre(place(random), place(random), place(random));
    Point3 p[3];
    for (Point3& q : p) q = centre + Vec3(offset(random), offset(random), offset(random));
    soup.add(p[0], p[1], p[2]);
  }
  return soup;
}

const Camera kCamera = look_at({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 1);

void expect_same(const ItemBuffer& a, const ItemBuffer& b) {
  ASSERT_EQ(a.item.size(), b.item.size());
  size_t different = 0;
  for (size_t i = 0; i < a.item.size(); ++i) {
    const bool tie = std::abs(a.distance[i] - b.distance[i]) < 1e-5f * a.distance[i];
    const bool both = a.item[i] != ItemBuffer::kNothing && b.item[i] != ItemBuffer::kNothing;
    if (a.item[i] != b.item[i] && !(tie && both)) {
      ++different;
    } else if (both) {
      EXPECT_NEAR(a.distance[i], b.distance[i], 1e-5 * double(a.distance[i]));
    }
  }
  EXPECT_EQ(different, 0U);
}

TEST(VertexStage, PutsVerticesWhereViewDoes) {
  const Soup soup = random_soup(100, 2, 1);
  const View view(kCamera, 83, 61);
  ScreenVertices screen;
  screen.resize(soup.positions.size());
  project_vertices(DrawList(soup.positions, soup.triangles), view, 0, soup.positions.size(), screen);
  for (size_t v = 0; v < soup.positions.size(); ++v) {
    const ScreenVertex s = view.project(view.clip_from_world() * Vec4(soup.positions[v], 1));
    EXPECT_NEAR(screen[v].x, s.x, 1);  // 1/256 px: fused multiply-adds round otherwise
    EXPECT_NEAR(screen[v].y, s.y, 1);
    EXPECT_NEAR(screen[v].depth, s.depth, 1e-6f * s.depth);
    EXPECT_FALSE(screen[v].to_be_clipped());
    const float x = float(s.x) / kSubpixels, y = float(s.y) / kSubpixels;
    if (x < -1.1f) EXPECT_TRUE(screen[v].outside & 128);
    if (x > 84.1f) EXPECT_TRUE(screen[v].outside & 64);
    if (y < -1.1f) EXPECT_TRUE(screen[v].outside & 256);
    if (y > 62.1f) EXPECT_TRUE(screen[v].outside & 512);
    if (x > -0.9f && x < 83.9f && y > -0.9f && y < 61.9f) EXPECT_EQ(screen[v].outside, 0);
  }
}

/// The nearest triangle along a ray, in doubles.
uint32_t hit_by(const Soup& soup, Point3d o, Vec3d d, double near) {
  double nearest = 1e30;
  uint32_t item = ItemBuffer::kNothing;
  for (uint32_t t = 0; t < soup.triangles.size(); ++t) {
    const auto p = [&](size_t k) { return Point3d(soup.positions[soup.triangles[t][k]]); };
    const Vec3d e = p(1) - p(0), f = p(2) - p(0), q = cross(d, f), to = o - p(0), r = cross(to, e);
    const double det = dot(e, q), u = dot(to, q) / det, v = dot(d, r) / det, at = dot(f, r) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && at > near && at < nearest) nearest = at, item = t;
  }
  return item;
}

/// Most of the triangles cross the plane of the eye; few of these can be seen. Pixels on edges may differ.
TEST(ItemRasterizer, FromWithinASoupAsRaysSeeIt) {
  const Soup soup = random_soup(300, 3, 4.0f);
  int differ = 0;
  for (int k = 0; k < 8; ++k) {
    const float a = 0.8f * float(k);
    const Point3 eye = soup.positions[5] + Vec3(0.1f);
    const Camera inside = look_at(eye, eye + Vec3(std::cos(a), 0.3f, std::sin(a)), {0, 1, 0}, 1.5f);
    const ItemBuffer items = soup.draw(inside, 64, 48);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x) {
        const CameraRay ray = camera_ray(inside, float(x) + 0.5f, float(y) + 0.5f, 64, 48);
        const double along = double(dot(ray.direction, inside.forward()));
        const uint32_t seen = hit_by(soup, Point3d(ray.origin), Vec3d(ray.direction), double(inside.near) / along);
        differ += seen != items.item[size_t(y) * 64 + size_t(x)];
      }
  }
  EXPECT_LT(differ, 8 * 64 * 48 / 200);
}

TEST(ItemRasterizer, LookedAtInBlocksIsTheSamePicture) {
  const Soup soup = random_soup(60, 5, 0.5f);
  const ItemBuffer items = soup.draw(kCamera, 37, 29);
  ItemRasterizer(soup.positions, soup.triangles)
      .look(kCamera, 37, 29, 0, [&](const BlockLayout& layout, std::span<const uint32_t> seen) {
        for (int y = 0; y < 29; ++y)
          for (int x = 0; x < 37; ++x)
            EXPECT_EQ(seen[layout.offset_of_pixel(x, y)], items.item[size_t(y) * 37 + size_t(x)]);
      });
}

TEST(ItemRasterizer, AgreesWithTheReadableForm) {
  for (const float size : {0.02f, 0.2f, 1.0f, 2.0f})
    for (uint32_t seed = 0; seed < 4; ++seed) {
      const Soup soup = random_soup(40, seed, size);
      expect_same(Reference(View(kCamera, 83, 61), soup.positions, soup.triangles).buffer, soup.draw(kCamera, 83, 61));
    }
}

TEST(ItemRasterizer, EveryInstructionSetGivesTheSameItems) {
  const Soup soup = random_soup(200, 7, 0.5f);
  const ItemBuffer best = soup.draw(kCamera, 120, 90);
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    expect_same(best, soup.draw(kCamera, 120, 90));
  }
  hwy::SetSupportedTargetsForTest(0);
}

/// How many of the triangles, each drawn by itself, cover each pixel.
std::vector<int> coverage(const Soup& soup, const Camera& camera, int size) {
  std::vector<int> count(size_t(size * size));
  for (const Triangle& t : soup.triangles) {
    Soup one;
    one.add(soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]);
    const ItemBuffer items = one.draw(camera, size, size);
    for (size_t i = 0; i < count.size(); ++i) count[i] += items.item[i] != ItemBuffer::kNothing;
  }
  return count;
}

/// A net of quadrilaterals whose vertices are moved at random, and often stand on pixel centres and corners.
Soup random_net(int size, uint32_t seed) {
  constexpr int kCells = 6;
  std::mt19937 random(seed);
  const int steps = std::array{2, 4, 256, 100000}[seed % 4];  // fractions of a pixel
  std::uniform_int_distribution<int> jitter(-steps * 3, steps * 3);
  Point3 p[kCells + 1][kCells + 1];
  for (int j = 0; j <= kCells; ++j)
    for (int i = 0; i <= kCells; ++i) {
      p[j][i] = {float(size * i) / kCells, float(size * j) / kCells, 0};
      if (i % kCells && j % kCells) p[j][i] += Vec3(jitter(random), jitter(random), 0) / float(steps);
    }
  Soup soup;
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      if (random() & 1) {
        soup.add(p[j][i], p[j][i + 1], p[j + 1][i + 1]), soup.add(p[j][i], p[j + 1][i + 1], p[j + 1][i]);
      } else {
        soup.add(p[j][i], p[j][i + 1], p[j + 1][i]), soup.add(p[j][i + 1], p[j + 1][i + 1], p[j + 1][i]);
      }
    }
  return soup;
}

TEST(ItemRasterizer, ATriangulationCoversEachPixelOnce) {
  constexpr int kSize = 64;
  for (uint32_t seed = 0; seed < 8; ++seed) {
    const Soup soup = random_net(kSize, seed);
    for (const int count : coverage(soup, pixel_camera(kSize), kSize)) ASSERT_EQ(count, 1) << "seed " << seed;
  }
}

TEST(ItemRasterizer, AFanOfHugeTrianglesCoversEachPixelOnce) {
  constexpr int kSize = 61;
  for (const double radius : {300.0, 40000.0, 3e6, 1e9}) {  // px: 32-bit, 64-bit, clipped at the guard band
    Soup soup;
    const Point3 hub(31.3f, 27.9f, 0);
    constexpr int kBlades = 11;
    const auto rim = [&](int i) {
      const double angle = 2 * kPi * (i % kBlades) / kBlades;
      return hub + Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
    };
    for (int i = 0; i < kBlades; ++i) soup.add(hub, rim(i), rim(i + 1));
    for (const int count : coverage(soup, pixel_camera(kSize), kSize)) ASSERT_EQ(count, 1) << "radius " << radius;
  }
}

TEST(ItemRasterizer, AFloorThatPassesTheEyeIsCutAtTheNearPlane) {
  Soup soup;  // y = -1, from behind the eye to near the horizon
  soup.add({-500, -1, 300}, {500, -1, 300}, {500, -1, -500});
  soup.add({-500, -1, 300}, {500, -1, -500}, {-500, -1, -500});
  Camera camera = look_at({0, 0, 0}, {0.2f, -0.3f, -1}, {0, 1, 0}, 1.2f);
  camera.near = 0.1f;
  constexpr int kWidth = 90, kHeight = 70;
  const ItemBuffer items = soup.draw(camera, kWidth, kHeight);
  // 1 / distance grows by this a pixel at most; corners are moved by up to half a sub-pixel in each direction.
  const double tolerance = 2 * std::tan(0.6) / kHeight / kSubpixels;
  int seen = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const CameraRay ray = camera_ray(camera, float(x) + 0.5f, float(y) + 0.5f, kWidth, kHeight);
      const float t = -1 / ray.direction.y;
      const Point3 p = t * ray.direction;
      const size_t at = size_t(y * kWidth + x);
      if (t > 0 && std::abs(p.x) < 490 && p.z > -490) {
        ASSERT_NE(items.item[at], ItemBuffer::kNothing) << x << ' ' << y;
        const float distance = t * dot(ray.direction, camera.forward());
        EXPECT_NEAR(1 / items.distance[at], 1 / distance, tolerance);
        ++seen;
      } else if (t < 0) {
        ASSERT_EQ(items.item[at], ItemBuffer::kNothing);
      }
    }
  EXPECT_GT(seen, 3000);
}

TEST(ItemRasterizer, WhatIsNearerThanTheNearPlaneOrBeyondTheFarOneIsNotSeen) {
  Soup soup;
  for (const float z : {-1.0f, -2.0f, -3.0f}) soup.add({-9, -9, z}, {9, -9, z}, {0, 9, z});
  Camera camera = look_at({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0.5f);
  camera.near = 1.5f;
  EXPECT_EQ(soup.draw(camera, 3, 3).item[4], 1U);
  camera.near = 2.5f, camera.far = 2.75f;
  EXPECT_EQ(soup.draw(camera, 3, 3).item[4], ItemBuffer::kNothing);
}

TEST(ItemRasterizer, DepthDoesNotDependOnTheOrderOfTriangles) {
  Soup soup = random_soup(300, 3, 0.4f);
  const ItemBuffer before = soup.draw(kCamera, 128, 128);
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), std::mt19937(1));
  EXPECT_EQ(before.distance, soup.draw(kCamera, 128, 128).distance);
}

TEST(ItemRasterizer, TheFirstOfTwoInTheSamePlaceIsSeen) {
  Soup soup = random_soup(1, 5, 1);
  for (int copy = 0; copy < 40; ++copy) soup.triangles.push_back(soup.triangles[0]);
  for (const uint32_t item : soup.draw(kCamera, 64, 64).item) EXPECT_TRUE(item == 0 || item == ItemBuffer::kNothing);
}

TEST(ItemRasterizer, TrianglesThatAreNoneDoNoHarm) {
  const float nan = std::nanf("");
  const float odd[] = {nan, kInfinity, -kInfinity, 3e38f, -3e38f, 1e-40f, 0, 1};
  std::mt19937 random(11);
  Soup soup;
  soup.add({-9, -9, 0}, {9, -9, 0}, {0, 9, 0});
  const auto any = [&] { return odd[random() % 8]; };
  for (int i = 0; i < 3000; ++i) {
    Point3 p[3];
    for (Point3& q : p) q = {any(), any(), any() - 2};
    if (std::isfinite(p[0].x + p[0].y + p[0].z) && std::isfinite(p[1].x) && std::isfinite(p[2].x)) p[1].y = nan;
    soup.add(p[0], p[1], p[2]);
  }
  const ItemBuffer items = soup.draw(kCamera, 40, 40);
  for (const uint32_t item : items.item) EXPECT_EQ(item, 0U);
}

TEST(ItemRasterizer, UpperRowsAreThoseOfTheWholePicture) {
  const Soup soup = random_soup(100, 9, 0.5f);
  const ItemBuffer whole = soup.draw(kCamera, 50, 50), upper = soup.draw(kCamera, 50, 50, 25);
  ASSERT_EQ(upper.height, 25);
  ASSERT_EQ(upper.item.size(), 50U * 25U);
  EXPECT_TRUE(std::equal(upper.item.begin(), upper.item.end(), whole.item.begin()));
}

TEST(ItemRasterizer, BacksAreLeftOutOnRequest) {
  Soup soup;
  soup.add({-9, -9, 0}, {0, 9, 0}, {9, -9, 0});  // clockwise: its back
  soup.add({-9, -9, -1}, {9, -9, -1}, {0, 9, -1});
  EXPECT_EQ(soup.draw(kCamera, 1, 1).item[0], 0U);
  EXPECT_EQ(soup.draw(kCamera, 1, 1, 0, true).item[0], 1U);
}

TEST(ItemRasterizer, OnePixelWindowsSeeWhatTheirCentreSees) {
  const Soup soup = random_soup(50, 13, 0.5f);
  EXPECT_EQ(soup.draw(kCamera, 1, 1).item[0], soup.draw(kCamera, 9, 9).item[40]);
}

TEST(ItemRasterizer, MayBeDrawnFromManyThreads) {
  const Soup soup = random_soup(200, 17, 0.5f);
  const ItemRasterizer rasterizer(soup.positions, soup.triangles);
  const ItemBuffer alone = soup.draw(kCamera, 64, 64);
  std::vector<ItemBuffer> out(64);
  parallel_for(out.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) rasterizer.draw(kCamera, 64, 64, out[i]);
  });
  for (const ItemBuffer& items : out) EXPECT_EQ(items.item, alone.item);
}

TEST(ItemRasterizer, WrongCallsAreRefused) {
  const Soup soup = random_soup(1, 1, 1);
  EXPECT_THROW(soup.draw(kCamera, 0, 5), Error);
  EXPECT_THROW(soup.draw(kCamera, 100000, 100000), Error);
  Camera flat = kCamera;
  flat.near = 0;
  EXPECT_THROW(soup.draw(flat, 5, 5), Error);
  const Triangle beyond[] = {{0, 1, 3}};
  EXPECT_THROW(ItemRasterizer(soup.positions, beyond), Error);
}

}  // namespace
}  // namespace aktina
