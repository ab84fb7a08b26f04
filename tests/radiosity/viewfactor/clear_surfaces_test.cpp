#include "aktina/radiosity/viewfactor/clear_surfaces.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/formfactor/closed_forms.h"
#include "aktina/radiosity/viewfactor/scene_surfaces.h"
#include "radiosity/scenes.h"
#include "radiosity/viewfactor/surfaces.h"

namespace aktina {
namespace {

/// A pane at a height, from (low, low) to (high, high), its front up.
Polygon pane(double height, double low, double high) {
  return {{{low, low, height}, {high, low, height}, {high, high, height}, {low, high, height}}};
}

/// Of each polygon what it lets through.
ViewFactorScene with_clear(std::vector<Polygon> polygons, std::vector<double> transmittances) {
  ViewFactorScene scene = one_each(std::move(polygons));
  scene.transmittances = std::move(transmittances);
  return scene;
}

TEST(ClearSurfaces, OnePaneLetsItsShareThrough) {
  const double open = opposed_rectangles(1, 1, 1);
  for (const double t : {0.0, 0.25, 0.9, 1.0}) {
    const ViewFactors f = view_factors(with_clear({unit_square(), ceiling(1), pane(0.5, -1, 2)}, {0, 0, t}), {});
    EXPECT_NEAR(f.at(0, 1), t * open, 1e-7) << t;
    EXPECT_NEAR(f.at(1, 0), t * open, 1e-7) << t;
  }
}

TEST(ClearSurfaces, PanesOneBehindTheOtherMultiply) {
  const double open = opposed_rectangles(1, 1, 1);
  const ViewFactors f =
      view_factors(with_clear({unit_square(), ceiling(1), pane(0.3, -1, 2), pane(0.6, -1, 2)}, {0, 0, 0.5, 0.8}), {});
  EXPECT_NEAR(f.at(0, 1), 0.4 * open, 1e-6);
}

TEST(ClearSurfaces, WhatAPaneDoesNotCoverPassesWhole) {
  const std::vector<Polygon> polygons = {unit_square(), ceiling(1), pane(0.5, 0.2, 0.7)};
  const double open = view_factors(one_each({unit_square(), ceiling(1)}), {}).at(0, 1),
               closed = view_factors(one_each(polygons), {}).at(0, 1);
  ASSERT_LT(closed, 0.9 * open);
  const ViewFactors f = view_factors(with_clear(polygons, {0, 0, 0.3}), {});
  EXPECT_NEAR(f.at(0, 1), closed + 0.3 * (open - closed), 1e-6);
}

/// Partly through one pane, partly through two: rays, within the target and the error that is told.
TEST(ClearSurfaces, UnequalLayersWithinTheTarget) {
  const std::vector<Polygon> polygons = {unit_square(), ceiling(1), pane(0.3, -1, 0.5), pane(0.6, -1, 2)};
  const ViewFactors f = view_factors(with_clear(polygons, {0, 0, 0.5, 0.8}), {.target_error = 1e-3});
  const double open = opposed_rectangles(1, 1, 1);
  const double first = view_factors(one_each({unit_square(), ceiling(1), pane(0.3, -1, 0.5)}), {}).at(0, 1);
  const double expected = 0.8 * (first + 0.5 * (open - first));
  EXPECT_NEAR(f.at(0, 1), expected, 3e-3);
  EXPECT_GT(f.errors[0], 0);
}

TEST(ClearSurfaces, AnEnclosureWithAPaneOfTwoSidesCloses) {
  std::vector<Polygon> all = box(2, 3, 2);
  const Polygon wall = {{{0, 1.4, 0}, {2, 1.4, 0}, {2, 1.4, 2}, {0, 1.4, 2}}};
  all.push_back(wall), all.push_back(turned_over(wall));
  const ViewFactors f = view_factors(with_clear(all, {0, 0, 0, 0, 0, 0, 0.6, 0.6}), {});
  for (size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f.row_sum(i), 1, 3e-4) << i;
}

TEST(ClearSurfaces, TheSameForAnyNumberOfThreads) {
  const ViewFactorScene scene =
      with_clear({unit_square(), ceiling(1), pane(0.3, -1, 0.5), pane(0.6, -1, 2)}, {0, 0, 0.5, 0.8});
  set_thread_count(1);
  const ViewFactors one = view_factors(scene, {});
  set_thread_count(3);
  const ViewFactors three = view_factors(scene, {});
  set_thread_count(0);
  EXPECT_EQ(one.factors, three.factors);
  EXPECT_EQ(one.errors, three.errors);
}

TEST(ClearSurfaces, MaterialsOfASceneWhereAskedFor) {
  Scene scene;
  add_quad(scene, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, Rgb(0.5f));
  add_quad(scene, {-1, 0.5f, -1}, {0, 0, 3}, {3, 0, 0}, Rgb(0.5f));
  scene.materials.back().alpha = 0.25f, scene.materials.back().alpha_mode = AlphaMode::blend;
  EXPECT_TRUE(surfaces_of(scene, SurfacesBy::face).transmittances.empty());
  const ViewFactorScene clear = surfaces_of(scene, SurfacesBy::face, Backs::hide, Clear::pass);
  ASSERT_EQ(clear.transmittances.size(), 2U);
  EXPECT_EQ(clear.transmittances[0], 0);
  EXPECT_NEAR(clear.transmittances[1], 0.75, 1e-6);
}

}  // namespace
}  // namespace aktina
