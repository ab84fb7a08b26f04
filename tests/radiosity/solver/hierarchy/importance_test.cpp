#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/hierarchy/hierarchy.h"
#include "aktina/radiosity/solver/hierarchy/view_importance.h"
#include "radiosity/solver/hierarchy/surfaces.h"

namespace aktina {
namespace {

std::vector<double> importance_of(const Surfaces& s, const Camera& view) {
  return view_importance(s.surfaces.layout(), s.problem.size(), s.visibility, view, 0);
}

/// Rooms of 2 x 2 x 2 m in a row along x, each with a lamp and a box, open to the next by a door at z = 0 .. 0.6.
Scene rooms(int count) {
  Scene scene = room({2.0f * float(count), 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  for (int i = 0; i < count; ++i) {
    const float x = 2 * float(i);
    add_quad(scene, {x + 0.7f, 1.999f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
    add_box(scene, {x + 0.5f, 0, 0.9f}, {0.5f, 0.8f, 0.5f}, Rgb(0.7f));
    if (i > 0) add_box(scene, {x - 0.05f, 0, 0.6f}, {0.1f, 2, 1.4f}, Rgb(0.6f));
  }
  return scene;
}

Camera into_the_last_room(int count) {
  Camera camera = look_at({2.0f * float(count) - 1.8f, 1, 1}, {2.0f * float(count), 0.8f, 1.2f}, {0, 1, 0}, 1.2f);
  camera.aspect = 1;
  return camera;
}

TEST(Importance, SharesOfThePictureSumToOneInAClosedRoom) {
  const Surfaces s(lit_room(true), 0.15);
  for (const auto kind : {Camera::Kind::perspective, Camera::Kind::orthographic}) {
    Camera view = look_at({0.2f, 1.1f, 1.7f}, {1.2f, 0.6f, 0.4f}, {0, 1, 0}, 0.9f);
    view.kind = kind, view.half_height = 0.1f;
    const std::vector<double> importance = importance_of(s, view);
    double sum = 0;
    for (size_t r = 0; r < importance.size(); ++r) sum += s.problem.areas[r] * importance[r];
    EXPECT_NEAR(sum, 1, 0.05);
  }
}

TEST(Importance, NothingBehindTheEyeOrBehindABoxIsSeen) {
  const Surfaces s(lit_room(true), 0.2);
  const Camera view = look_at({0.6f, 0.4f, 1.9f}, {0.7f, 0.4f, 0.5f}, {0, 1, 0}, 0.5f);
  const std::vector<double> importance = importance_of(s, view);
  double seen = 0;
  for (size_t r = 0; r < importance.size(); ++r) {
    const Point3 at = s.sides.centre(r);
    const bool behind_eye = at.z > 1.95f;
    const bool behind_box = at.z < 0.01f && at.y < 1.1f && at.x > 0.5f && at.x < 1.3f;
    if (behind_eye || behind_box) {
      EXPECT_EQ(importance[r], 0) << at.x << " " << at.y << " " << at.z;
    }
    seen += importance[r];
  }
  EXPECT_GT(seen, 0);
}

/// What the picture shows is the light that is emitted, weighted by importance (Smits et al., eq. 5).
TEST(Importance, IsTheAdjointOfLight) {
  Scene scene = room({2, 2, 2}, Rgb(0.5f));
  add_quad(scene, {0.7f, 1.999f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0.5f), Rgb(100));
  add_box(scene, {0.5f, 0, 0.5f}, {0.5f, 0.8f, 0.5f}, Rgb(0.5f));
  const Surfaces s(std::move(scene), 0.25);
  const Camera view = look_at({0.2f, 1.1f, 1.7f}, {1.2f, 0.3f, 0.4f}, {0, 1, 0}, 0.7f);
  HierarchyOptions options;
  options.most = 1e-6, options.view = &view;
  LinkedTree tree(s.problem, s.surfaces, options, 0);
  for (const double times : {64, 16, 4, 1}) {
    tree.link(times, nullptr);
    for (int k = 0; k < 12; ++k) tree.exchange();
  }
  const std::vector<double> importance = importance_of(s, view), h = tree.light().receivers();
  double shown = 0;
  for (size_t r = 0; r < importance.size(); ++r) {
    const size_t k = 3 * r + 1;
    const double b = s.problem.emissions[k] + s.problem.reflectances[k] * h[k];
    shown += s.problem.areas[r] * importance[r] * b;
  }
  double emitted = 0;
  for (uint32_t node = 0; node < tree.tree().nodes().size(); ++node) {
    if (!tree.tree().is_leaf(node)) continue;
    const double reflected = tree.light().radiosity(node)[3];
    for (const SurfaceTree::Overlap& each : tree.tree().overlaps(node))
      emitted += each.area * reflected / 0.5 * s.problem.emissions[3 * each.receiver + 1];
  }
  EXPECT_NEAR(emitted / shown, 1, 0.05);
}

TEST(Importance, LinksWhatTheViewNeedsAndLosesNothingOfIt) {
  constexpr int kRooms = 4;
  const Surfaces s(rooms(kRooms), 0.2);
  const Camera view = into_the_last_room(kRooms);
  const std::vector<double> seen = importance_of(s, view);
  struct Outcome {
    size_t links;
    std::vector<double> light;
  };
  const auto solve = [&](const Camera* from, double most, bool clusters) {
    HierarchyOptions options;
    options.most = most, options.view = from, options.clusters = clusters;
    LinkedTree tree(s.problem, s.surfaces, options, 0);
    for (const double times : {64, 16, 4, 1}) {
      tree.link(times, nullptr);
      for (int k = 0; k < 4; ++k) tree.exchange();
    }
    for (int k = 0; k < 6; ++k) tree.exchange();
    return Outcome{tree.links().size() + tree.cluster_links(), tree.light().receivers()};
  };
  const auto error = [&](const std::vector<double>& light, const std::vector<double>& exact) {
    double squares = 0, mean = 0, weights = 0;
    for (size_t r = 0; r < seen.size(); ++r) {
      const double w = seen[r] * s.problem.areas[r], e = exact[3 * r + 1];
      squares += w * std::pow(light[3 * r + 1] - e, 2), mean += w * e, weights += w;
    }
    return std::sqrt(squares / weights) / (mean / weights);
  };
  const std::vector<double> exact = solve(nullptr, 1e-6, false).light;
  for (const bool clusters : {false, true}) {
    const Outcome all = solve(nullptr, 2e-5, clusters), needed = solve(&view, 2e-5, clusters);
    EXPECT_LT(double(needed.links), 0.2 * double(all.links)) << clusters;
    EXPECT_LT(error(needed.light, exact), 1.1 * error(all.light, exact) + 0.001) << clusters;
  }
}

TEST(Importance, OfEveryKindOfBasis) {
  const Scene scene = rooms(2);
  for (const char* solver : {"hierarchical", "clustering", "wavelet_m2", "wavelet_f2"}) {
    RadiosityOptions options{.solver = solver, .patch_size = 0.3, .target_error = 0.03};
    const Solution all = solve_radiosity(scene, options);
    options.importance = into_the_last_room(2);
    const Solution needed = solve_radiosity(scene, options);
    double light = 0, difference = 0;
    for (size_t i = 0; i < all.mesh.size(); ++i) {
      if (all.mesh.positions[all.mesh.patches[i][0]].x < 2.1f) continue;
      light += double(all.irradiances[i].v.g);
      difference += double(std::abs(all.irradiances[i].v.g - needed.irradiances[i].v.g));
    }
    EXPECT_LT(difference, 0.04 * light) << solver;
    EXPECT_GT(difference, 0) << solver;
  }
}

TEST(Importance, IsRefusedWhereASolverTakesNoAccountOfIt) {
  const Scene scene = lit_room(false);
  const RadiosityOptions options{.patch_size = 0.5, .importance = Camera()};
  try {
    solve_radiosity(scene, options);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), Code::unsupported);
  }
}

}  // namespace
}  // namespace aktina
