// Patches and elements, on form factors that are exact: an empty room of rectangles.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "aktina/radiosity/formfactor/polygon_to_polygon.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/factor_matrix.h"
#include "aktina/radiosity/solver/solver.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

constexpr uint32_t kPerWall = 4;  // patches, 2 x 2

/// A rectangle of the wall's square, in its own coordinates.
struct Rectangle {
  uint32_t wall, patch;
  double low[2], high[2];
};

/// The inside of a box of 1 x 1.3 x 0.8 m; patches are a fourth of a wall each and have n x n elements.
class ExactRoom : public FactorSource {
 public:
  explicit ExactRoom(uint32_t n) {
    for (uint32_t patch = 0; patch < 6 * kPerWall; ++patch) per_patch.push_back(n);
    make();
  }
  void make() {
    elements.clear(), problem = {};
    problem.bands = 1, problem.weights = {1};
    for (uint32_t patch = 0; patch < per_patch.size(); ++patch) {
      const uint32_t wall = patch / kPerWall, n = per_patch[patch];
      problem.shooters.push_back({uint32_t(elements.size()), n * n});
      for (uint32_t k = 0; k < n * n; ++k) {
        const auto row = k / n, upper = patch / 2 % 2;
        const double step = 0.5 / n, u = 0.5 * (patch % 2) + step * (k % n), v = 0.5 * upper + step * row;
        elements.push_back({wall, patch, {u, v}, {u + step, v + step}});
        problem.areas.push_back(face(elements.back()).area);
        problem.reflectances.push_back(0.3 + 0.1 * wall);
        problem.emissions.push_back(patch == 1 ? 10 : 0);
      }
    }
  }
  Face face(const Rectangle& r) const {
    // corner, u, v of each wall; the front is towards u x v
    static const Vec3d walls[6][3] = {{{0, 0, 0}, {0, 0, 0.8}, {1, 0, 0}},   {{0, 1.3, 0}, {1, 0, 0}, {0, 0, 0.8}},
                                      {{0, 0, 0}, {0, 1.3, 0}, {0, 0, 0.8}}, {{1, 0, 0}, {0, 0, 0.8}, {0, 1.3, 0}},
                                      {{0, 0, 0}, {1, 0, 0}, {0, 1.3, 0}},   {{0, 0, 0.8}, {0, 1.3, 0}, {1, 0, 0}}};
    const auto& w = walls[r.wall];
    const auto at = [&](double u, double v) { return Point3d(w[0] + u * w[1] + v * w[2]); };
    return make_face(
        Polygon{{at(r.low[0], r.low[1]), at(r.high[0], r.low[1]), at(r.high[0], r.high[1]), at(r.low[0], r.high[1])}},
        "");
  }
  Rectangle whole(uint32_t patch) const {
    const double u = 0.5 * (patch % 2), v = 0.5 * (patch / 2 % 2);
    return {patch / kPerWall, patch, {u, v}, {u + 0.5, v + 0.5}};
  }
  double factor(size_t element, uint32_t shooter) const {
    if (elements[element].wall == shooter / kPerWall) return 0;
    return exchange_area(face(elements[element]), face(whole(shooter))) / problem.areas[element];
  }
  void column(size_t shooter, std::span<double> factors) const override {
    ++columns;
    for (size_t s = 0; s < factors.size(); ++s) factors[s] = factor(s, uint32_t(shooter));
  }

  std::vector<uint32_t> per_patch;
  std::vector<Rectangle> elements;
  RadiosityProblem problem;
  mutable size_t columns = 0;
};

RadiosityState solve(const ExactRoom& room, std::string_view method, const SolverControl& control) {
  return make_method(solvers(), "radiosity", method)->solve(room.problem, room, control);
}

/// Area means over each patch of the radiosities of its elements.
std::vector<double> patch_means(const RadiosityProblem& p, const RadiosityState& state) {
  std::vector<double> means;
  for (const auto range : p.shooters) {
    double sum = 0, area = 0;
    for (size_t s = range.first; s < range.first + range.count; ++s)
      sum += p.areas[s] * state.radiosity(p, s, 0), area += p.areas[s];
    means.push_back(sum / area);
  }
  return means;
}

TEST(Substructured, WeightedRowsOfElementsAreThoseOfPatches) {
  const ExactRoom elements(3), patches(1);
  const FactorMatrix weighted(elements.problem, elements, {}), plain(patches.problem, patches, {});
  for (size_t i = 0; i < plain.size(); ++i)
    for (size_t j = 0; j < plain.size(); ++j) EXPECT_NEAR(weighted.entry(i, j, 0), plain.entry(i, j, 0), 1e-12);
}

TEST(Substructured, ElementsThatArePatchesGiveProgressiveRefinement) {
  const ExactRoom room(1);
  const RadiosityState plain = solve(room, "progressive", {.tolerance = 1e-6}),
                       state = solve(room, "substructured", {.tolerance = 1e-6});
  EXPECT_EQ(state.irradiances, plain.irradiances);
  EXPECT_EQ(state.steps, plain.steps);
}

TEST(Substructured, ElementsAverageToTheRadiosityOfTheirPatch) {
  const ExactRoom patches(1), elements(3);
  const RadiosityState coarse = solve(patches, "matrix", {.tolerance = 1e-13}),
                       fine = solve(elements, "substructured", {.tolerance = 1e-13});
  const std::vector<double> expected = patch_means(patches.problem, coarse),
                            means = patch_means(elements.problem, fine);
  for (size_t i = 0; i < means.size(); ++i) EXPECT_NEAR(means[i], expected[i], 1e-11);
}

TEST(Substructured, CostsAColumnAPatchNotAnElement) {
  const ExactRoom elements(3);
  const RadiosityState state = solve(elements, "substructured", {.tolerance = 0, .most_steps = 50});
  EXPECT_EQ(elements.columns, 50U);
  EXPECT_EQ(elements.problem.shooters.size(), 24U);
}

/// Splits the elements of patches whose elements differ by more than a tenth of their mean.
class Halving : public ElementSplitter {
 public:
  explicit Halving(ExactRoom& room) : room_(room) {}
  bool split(const RadiosityState& state) override {
    std::vector<uint8_t> steep;
    const RadiosityProblem& p = room_.problem;
    std::vector<uint32_t> first;
    bool any = false;
    for (size_t j = 0; j < p.shooters.size(); ++j) {
      const auto range = p.shooters[j];
      first.push_back(range.first);
      const auto begin = state.irradiances.begin() + range.first;
      const auto [low, high] = std::minmax_element(begin, begin + range.count);
      const bool marked = room_.per_patch[j] < 4 && *high - *low > 0.1 * *high;
      if (marked) room_.per_patch[j] *= 2;
      steep.push_back(marked), any = any || marked;
    }
    if (!any) return false;
    room_.make();
    origins_.clear(), new_.clear();
    for (size_t j = 0; j < room_.problem.shooters.size(); ++j)
      for (uint32_t k = 0; k < room_.problem.shooters[j].count; ++k) {
        if (steep[j]) new_.push_back(uint32_t(origins_.size()));
        origins_.push_back(steep[j] ? kNew : first[j] + k);
      }
    return true;
  }
  const RadiosityProblem& problem() const override { return room_.problem; }
  const FactorSource& factors() const override { return room_; }
  std::span<const uint32_t> origins() const override { return origins_; }
  void column_of_new(size_t shooter, std::span<double> factors) const override {
    ASSERT_EQ(factors.size(), new_.size());
    for (size_t i = 0; i < new_.size(); ++i) factors[i] = room_.factor(new_[i], uint32_t(shooter));
    computed += new_.size();
  }
  mutable size_t computed = 0;

 private:
  ExactRoom& room_;
  std::vector<uint32_t> origins_, new_;
};

TEST(Substructured, SplittingEndsWhereStartingAnewDoes) {
  ExactRoom room(2);
  Halving splitter(room);
  SolverControl control{.tolerance = 1e-12, .splitter = &splitter};
  const RadiosityState state = solve(room, "substructured", control);
  ASSERT_GT(splitter.computed, 0U);
  EXPECT_LT(room.elements.size(), 24U * 16) << "some patches stay as they are";
  EXPECT_TRUE(state.converged);
  const size_t split_columns = room.columns;
  const RadiosityState anew = solve(room, "matrix", {.tolerance = 1e-13});
  for (size_t s = 0; s < room.elements.size(); ++s) {
    EXPECT_NEAR(state.irradiances[s], anew.irradiances[s], 1e-10);
    EXPECT_NEAR(state.direct[s], anew.direct[s], 1e-10);
  }
  EXPECT_NEAR(state.emitted, state.absorbed + state.escaped + unshot_flux(room.problem, state), 1e-12 * state.emitted);
  EXPECT_NEAR(state.escaped, 0, 1e-9 * state.emitted) << "exact factors lose nothing";
  // What patches had shot is not shot again to all: the second balance needs fewer shots than the first.
  room.columns = 0;
  solve(room, "progressive", control);
  EXPECT_LT(split_columns, 2 * room.columns);
}

/// RMS over all area between the elements of `state` and those of a room of 8 x 8 elements a patch.
double error_against(const ExactRoom& fine, const RadiosityState& truth, const ExactRoom& room,
                     const RadiosityState& state) {
  double sum = 0, area = 0;
  for (size_t f = 0; f < fine.elements.size(); ++f) {
    const Rectangle& e = fine.elements[f];
    const auto range = room.problem.shooters[e.patch];
    const uint32_t n = room.per_patch[e.patch];
    const auto cell = [&](int axis) {
      const double low = room.whole(e.patch).low[axis];
      return uint32_t((0.5 * (e.low[axis] + e.high[axis]) - low) / 0.5 * n);
    };
    const size_t s = range.first + cell(1) * n + cell(0);
    const double off = state.radiosity(room.problem, s, 0) - truth.radiosity(fine.problem, f, 0);
    sum += fine.problem.areas[f] * off * off, area += fine.problem.areas[f];
  }
  return std::sqrt(sum / area);
}

TEST(Substructured, RefinementBringsItNearerToAFineSolution) {
  const ExactRoom fine(8);
  const RadiosityState truth = solve(fine, "progressive", {.tolerance = 1e-6});
  const ExactRoom one(1), two(2);
  const double coarse = error_against(fine, truth, one, solve(one, "substructured", {.tolerance = 1e-6})),
               better = error_against(fine, truth, two, solve(two, "substructured", {.tolerance = 1e-6}));
  ExactRoom split(2);
  Halving splitter(split);
  const SolverControl control{.tolerance = 1e-6, .splitter = &splitter};
  const double best = error_against(fine, truth, split, solve(split, "substructured", control));
  EXPECT_LT(better, 0.65 * coarse);
  EXPECT_LT(best, 0.65 * better);
}

/// A closed room with a lamp in its ceiling and a box on the floor, all light on all patches.
Solution solve_room(const std::string& solver, const std::string& formfactor, int depth) {
  Scene scene = room({2, 2, 2}, Rgb(0.6f, 0.5f, 0.4f));
  add_quad(scene, {0.7f, 1.99f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
  add_box(scene, {0.5f, 0.2f, 0.5f}, {0.5f, 0.6f, 0.5f}, Rgb(0.7f));
  RadiosityOptions options{.solver = solver, .formfactor = formfactor};
  options.mesher = "quadtree:depth=" + std::to_string(depth);
  options.patch_size = 0.4, options.indirect_size = 0, options.tolerance = 1e-3;
  return solve_radiosity(scene, options);
}

TEST(Substructured, SplitsElementsOfScenesByRays) {
  const Solution whole = solve_room("substructured", "ray_cast", 0), split = solve_room("substructured", "ray_cast", 2);
  EXPECT_GT(split.mesh.size(), 2 * whole.mesh.size());
  EXPECT_TRUE(split.converged);
  EXPECT_EQ(split.mesh.shooters.size(), whole.mesh.shooters.size()) << "patches stay, elements are split";
  const Solution anew = solve_room("progressive", "ray_cast", 2);
  ASSERT_NEAR(double(anew.mesh.size()), double(split.mesh.size()), 0.05 * double(split.mesh.size()));
  EXPECT_LT(split.steps, 2 * anew.steps);
  double split_light = 0, anew_light = 0;
  for (size_t i = 0; i < split.mesh.size(); ++i) split_light += double(split.mesh.areas[i] * split.irradiances[i].v.g);
  for (size_t i = 0; i < anew.mesh.size(); ++i) anew_light += double(anew.mesh.areas[i] * anew.irradiances[i].v.g);
  EXPECT_NEAR(split_light, anew_light, 0.005 * anew_light);
}

TEST(Substructured, SplitsElementsOfScenesByRows) {
  const Solution whole = solve_room("substructured", "hemicube:resolution=32,hemicubes=1", 0),
                 split = solve_room("substructured", "hemicube:resolution=32,hemicubes=1", 1);
  EXPECT_GT(split.mesh.size(), whole.mesh.size());
  EXPECT_TRUE(split.converged);
}

TEST(Substructured, LampsShineOnNewElements) {
  Scene scene = room({2, 2, 2}, Rgb(0.5f));
  scene.lights.push_back({"lamp", PointLight{{0.4f, 1.6f, 0.4f}, Intensity(Rgb(10))}, -1});
  RadiosityOptions options{.solver = "substructured", .mesher = "quadtree:depth=2"};
  options.patch_size = 0.4, options.indirect_size = 0;
  const Solution s = solve_radiosity(scene, options);
  EXPECT_GT(s.mesh.size(), 400U);
  for (size_t i = 0; i < s.mesh.size(); ++i) {
    Point3 p(0);
    const size_t n = s.mesh.is_quad(i) ? 4 : 3;
    for (size_t k = 0; k < n; ++k) p += s.mesh.positions[s.mesh.patches[i][k]] * (1 / float(n));
    const Vec3 d = Point3(0.4f, 1.6f, 0.4f) - p;
    const float exact = 10 * dot(d, s.mesh.patch_normals[i]) / (squared_length(d) * length(d));
    EXPECT_NEAR(s.direct_irradiances[i].v.g, exact, 0.1f * exact);
  }
}

}  // namespace
}  // namespace aktina
