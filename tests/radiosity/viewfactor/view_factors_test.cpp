#include "aktina/radiosity/viewfactor/view_factors.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "aktina/radiosity/formfactor/closed_forms.h"
#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/viewfactor/certificate.h"
#include "aktina/radiosity/viewfactor/gray_body.h"
#include "radiosity/viewfactor/surfaces.h"
#include "test_files.h"

namespace aktina {
namespace {

/// A closed room of 2 x 3 x 2 with a box in it, fronts outward.
ViewFactorScene room_with_box() {
  std::vector<Polygon> all = box(2, 3, 2);
  for (const Polygon& p : box(0.6, 0.8, 0.5)) all.push_back(moved(turned_over(p), {0.5, 0.9, 0.4}));
  return one_each(all);
}

TEST(ViewFactors, OpposedSquaresAsTheClosedForm) {
  const ViewFactors f = view_factors(one_each({unit_square(), ceiling(1)}), {});
  EXPECT_NEAR(f.at(0, 1), opposed_rectangles(1, 1, 1), 1e-12);
  EXPECT_EQ(f.at(0, 0), 0);
  EXPECT_DOUBLE_EQ(f.areas[0], 1);
}

TEST(ViewFactors, AClosedRoomWithABoxClosesAndIsCertified) {
  const ViewFactors f = view_factors(room_with_box(), {});
  for (size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f.row_sum(i), 1, 2e-4) << i;
  const Certificate c = certify(f);
  EXPECT_TRUE(c.closed);
  EXPECT_LT(c.worst_reciprocity, 1e-15);
  EXPECT_EQ(c.out_of_bounds, 0U);
  EXPECT_GE(c.least, 0);
  EXPECT_LE(c.largest_error, 1e-4);
  EXPECT_EQ(c.worst.size(), 10U);
  for (size_t k = 1; k < c.worst.size(); ++k)
    EXPECT_GE(std::abs(c.worst[k - 1].sum - 1), std::abs(c.worst[k].sum - 1)) << "the worst first";
}

/// A lamp a hundredth below the ceiling and a box a hundredth above the floor: light passes where few points look.
TEST(ViewFactors, NarrowGapsCount) {
  std::vector<Polygon> all = box(2, 3, 2);
  all.push_back({{{0.7, 1.2, 1.99}, {0.7, 1.8, 1.99}, {1.3, 1.8, 1.99}, {1.3, 1.2, 1.99}}});
  for (const Polygon& p : box(0.6, 0.6, 0.8)) all.push_back(moved(turned_over(p), {0.5, 1, 0.01}));
  // Lambert's form of the ceiling without the union of both shadows, at 15 million points of the floor.
  const double floor_to_ceiling = 0.1918004;
  for (const double target : {1e-3, 1e-4, 1e-6}) {
    const ViewFactors f = view_factors(one_each(all), {.target_error = target});
    EXPECT_NEAR(f.at(0, 1), floor_to_ceiling, target + 2e-7) << target;
  }
}

TEST(ViewFactors, WhereItIsStoppedTheRowsThatAreCompleteStay) {
  std::vector<Polygon> all = box(2, 3, 2);
  for (int k = 0; k < 60; ++k) {
    const Vec3d at(0.2 + 0.4 * (k % 4), 0.2 + 0.5 * (k / 4 % 5), 0.3 + 0.5 * (k / 20));
    for (const Polygon& p : box(0.1, 0.1, 0.1)) all.push_back(moved(turned_over(p), at));
  }
  const ViewFactorScene scene = one_each(all);
  const ViewFactors whole = view_factors(scene, {});
  Progress* running = nullptr;
  Progress progress([&](const ProgressState& state) { state.done >= 6 ? running->cancel() : void(); }, 0);
  running = &progress;
  const ViewFactors f = view_factors(scene, {}, &progress);
  ASSERT_EQ(f.complete.size(), f.size());
  const auto complete = std::count(f.complete.begin(), f.complete.end(), 1);
  EXPECT_GT(complete, 0);
  EXPECT_LT(complete, std::ptrdiff_t(f.size()));
  for (size_t i = 0; i < f.size(); ++i)
    for (size_t j = 0; j < f.size(); ++j) EXPECT_EQ(f.at(i, j), f.known(i, j) ? whole.at(i, j) : 0) << i << ' ' << j;
  EXPECT_GE(certify(f).least_sum, certify(whole).least_sum) << "of the complete rows";
}

TEST(ViewFactors, StoppedBeforeARowIsCompleteIsCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(view_factors(room_with_box(), {}, &progress), Error);
}

/// Held against the contours, whose occluders are no bodies: they only hide, from outside and from inside.
void expect_as_contours(const std::vector<Polygon>& polygons, double target) {
  const ViewFactors f = view_factors(one_each(polygons), {.target_error = target});
  const auto contour = make_method(formfactors(), "formfactor", "contour:tolerance=1e-7");
  contour->build({polygons, {}});
  for (size_t i = 0; i < polygons.size(); ++i) {
    const FormFactorRow row = contour->row(i);
    for (size_t j = 0; j < polygons.size(); ++j)
      EXPECT_NEAR(f.at(i, j), row.factors[j], target + 1e-6) << i << " to " << j << ", target " << target;
  }
}

TEST(ViewFactors, APlateThatReachesALittleThroughAWall) {
  std::vector<Polygon> all = box(2.6, 1.7, 1.1);
  all.push_back({{{0.35, 0.9, 0.55}, {1.05, 0.9, 0.55}, {1.05, 1.705, 0.55}, {0.35, 1.705, 0.55}}});
  for (const double target : {1e-3, 1e-4, 1e-5, 1e-6}) expect_as_contours(all, target);
}

TEST(ViewFactors, WallsThatReachIntoABoxSeeEachOtherThere) {
  std::vector<Polygon> walls = box(2.8, 1.5, 1.1);
  std::vector<Polygon> all = {walls[1], walls[4]};
  for (const Polygon& p : box(0.7, 0.75, 0.4)) all.push_back(moved(turned_over(p), {0.9, 1, 0.75}));
  expect_as_contours(all, 1e-4);
}

TEST(ViewFactors, BoxesThatReachIntoEachOther) {
  std::vector<Polygon> all;
  for (const Polygon& p : box(1, 1, 1)) all.push_back(turned_over(p));
  for (const Polygon& p : box(0.8, 0.6, 0.7)) all.push_back(moved(turned_over(p), {0.7, 0.3, 0.8}));
  expect_as_contours(all, 1e-4);
}

TEST(ViewFactors, AnOpenSceneIsNotCalledClosed) {
  std::vector<Polygon> walls = box(1, 1, 1);
  walls.pop_back();
  const Certificate c = certify(view_factors(one_each(walls), {}));
  EXPECT_FALSE(c.closed);
  EXPECT_NEAR(c.least_sum, 1 - perpendicular_rectangles(1, 1, 1), 1e-9) << "beside the opening: that is missing";
  EXPECT_NEAR(c.most_sum, 1 - opposed_rectangles(1, 1, 1), 1e-9) << "opposite to it";
}

TEST(ViewFactors, SurfacesOfSeveralPiecesAddUp) {
  const ViewFactors fine = view_factors(room_with_box(), {.target_error = 1e-6});
  ViewFactorScene grouped = room_with_box();
  grouped.names = {"room", "box"};
  for (size_t i = 0; i < grouped.owners.size(); ++i) grouped.owners[i] = i < 6 ? 0 : 1;
  const ViewFactors f = view_factors(grouped, {.target_error = 1e-6});
  ASSERT_EQ(f.size(), 2U);
  EXPECT_NEAR(f.at(1, 0), 1, 1e-5) << "a convex box sees the room only";
  EXPECT_EQ(f.at(1, 1), 0);
  EXPECT_NEAR(f.at(0, 1), f.areas[1] / f.areas[0], 1e-5) << "reciprocity";
  double sum = 0;
  for (size_t i = 0; i < 6; ++i)
    for (size_t j = 0; j < 6; ++j) sum += fine.areas[i] * fine.at(i, j);
  EXPECT_NEAR(f.at(0, 0), sum / f.areas[0], 1e-6) << "what the room sees of itself";
}

TEST(ViewFactors, OccludersHideOnly) {
  ViewFactorScene scene = one_each({unit_square(), ceiling(1)});
  scene.occluders = {{{{-0.1, -0.1, 0.5}, {1.1, -0.1, 0.5}, {1.1, 1.1, 0.5}, {-0.1, 1.1, 0.5}}}};
  const ViewFactors f = view_factors(scene, {});
  EXPECT_EQ(f.size(), 2U);
  EXPECT_EQ(f.at(0, 1), 0);
  EXPECT_TRUE(f.columns.empty()) << "nothing is stored for what is not seen";
}

TEST(ViewFactors, TheSameForAnyNumberOfThreads) {
  set_thread_count(1);
  const ViewFactors one = view_factors(room_with_box(), {});
  set_thread_count(3);
  const ViewFactors three = view_factors(room_with_box(), {});
  set_thread_count(0);
  EXPECT_EQ(one.factors, three.factors);
  EXPECT_EQ(one.errors, three.errors);
}

TEST(ViewFactors, AMatrixThatWouldNotFitIsRefusedWithTheSizeThatWould) {
  try {
    view_factors(room_with_box(), {.most_bytes = 1000});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::limit);
    EXPECT_THAT(error.what(), testing::HasSubstr("fit"));
  }
  EXPECT_THROW(view_factors({}, {}), Error);
  EXPECT_THROW(view_factors(room_with_box(), {.target_error = 0}), Error);
}

TEST(ViewFactors, WhatDoesNotFitGoesIntoFilesOfAFolderAndLeavesNothingThere) {
  const test::TemporaryFolder folder;
  const ViewFactors memory = view_factors(room_with_box(), {});
  double foreseen = 0;
  const ViewFactors files = view_factors(
      room_with_box(), {.most_bytes = 1000, .scratch = folder.path(), .foreseen = [&](double b) { foreseen = b; }});
  EXPECT_EQ(memory.starts, files.starts);
  EXPECT_EQ(memory.columns, files.columns);
  EXPECT_EQ(memory.factors, files.factors);
  EXPECT_EQ(memory.errors, files.errors);
  EXPECT_NEAR(foreseen, double(memory.factors.size()) * 24, 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  try {
    view_factors(room_with_box(), {.most_bytes = 1000, .scratch = folder.path() / "nowhere"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::io);
  }
}

/// A chip a little above a large floor, with more sticks about it than can be cut out: rays over all of the floor would
/// mostly look where the chip's light does not arrive.
TEST(ViewFactors, SmallThingsCloseToLargeOnesAmongManyBlockers) {
  std::vector<Polygon> all = box(4, 4, 2.5);
  const size_t chip = all.size();
  for (const Polygon& p : box(0.05, 0.05, 0.002)) all.push_back(moved(turned_over(p), {2, 2, 0.03}));
  for (int k = 0; k < 90; ++k) {
    const double angle = 0.7 * k, r = 0.06 + 0.002 * k;
    for (const Polygon& p : box(0.003, 0.003, 0.05))
      all.push_back(moved(turned_over(p), {2.025 + r * std::cos(angle), 2.025 + r * std::sin(angle), 0.001}));
  }
  const ViewFactors f = view_factors(one_each(all), {.target_error = 1e-3});
  for (size_t i = chip; i < chip + 6; ++i) EXPECT_NEAR(f.row_sum(i), 1, 0.02) << i;
}

TEST(Repair, ClosesRowsAndKeepsReciprocityAndZeros) {
  ViewFactors f = view_factors(room_with_box(), {});
  for (size_t k = 0; k < f.factors.size(); ++k) f.factors[k] *= 1 + 1e-3 * std::sin(double(k));
  const size_t stored = f.factors.size();
  // Made symmetric again: a repair starts from exchange areas.
  for (size_t i = 0; i < f.size(); ++i)
    for (uint64_t k = f.starts[i]; k < f.starts[i + 1]; ++k)
      if (f.columns[k] < i) f.factors[k] = f.areas[f.columns[k]] * f.at(f.columns[k], i) / f.areas[i];
  const double change = repair(f);
  EXPECT_GT(change, 0);
  EXPECT_LT(change, 2e-3);
  EXPECT_EQ(f.factors.size(), stored);
  for (size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f.row_sum(i), 1, 1e-12);
  EXPECT_LT(certify(f).worst_reciprocity, 1e-14);
}

TEST(Repair, RefusesWhatIsNoEnclosure) {
  ViewFactors f = view_factors(one_each({unit_square(), ceiling(1)}), {});
  EXPECT_THROW(repair(f), Error);
}

/// Two plates so near that they see only each other.
ViewFactors plates() {
  ViewFactors f;
  f.names = {"hot", "cold"}, f.areas = {2, 2};
  f.starts = {0, 1, 2}, f.columns = {1, 0}, f.factors = {1, 1}, f.errors = {0, 0};
  return f;
}

TEST(GrayBody, ParallelPlatesAsTheClosedForm) {
  const std::vector<GrayBody> bodies{{.emissivity = 0.8, .temperature = 500}, {.emissivity = 0.3, .temperature = 300}};
  const double script_f = 1 / (1 / 0.8 + 1 / 0.3 - 1);
  const GrayExchange exchange = gray_exchange(plates(), bodies);
  EXPECT_NEAR(exchange.script_f[1], script_f, 1e-14);
  EXPECT_NEAR(exchange.script_f[2], script_f, 1e-14) << "symmetric where areas are equal";
  EXPECT_NEAR(exchange.gebhart[0] + exchange.gebhart[1], 1, 1e-14) << "all is absorbed somewhere";
  const GrayBalance balance = gray_balance(plates(), bodies, 0);
  const double flux = script_f * kStefanBoltzmann * (std::pow(500, 4) - std::pow(300, 4));
  EXPECT_NEAR(balance.fluxes[0], flux, 1e-10 * flux);
  EXPECT_NEAR(balance.fluxes[1], -flux, 1e-10 * flux);
  EXPECT_NEAR(balance.net, 0, 1e-9 * flux);
}

TEST(GrayBody, AGivenFluxFindsTheTemperatureThatCausesIt) {
  const double flux = kStefanBoltzmann / (1 / 0.8 + 1 / 0.3 - 1) * (std::pow(500, 4) - std::pow(300, 4));
  const GrayBalance balance =
      gray_balance(plates(), {{.emissivity = 0.8, .flux = flux}, {.emissivity = 0.3, .temperature = 300}}, 0);
  EXPECT_NEAR(balance.temperatures[0], 500, 1e-9);
  EXPECT_EQ(balance.temperatures[1], 300);
}

TEST(GrayBody, NetworkAndExchangeFactorsAgreeInARoom) {
  const ViewFactors f = view_factors(room_with_box(), {});
  std::vector<GrayBody> bodies;
  for (size_t i = 0; i < f.size(); ++i)
    bodies.push_back({.emissivity = 0.1 + 0.07 * double(i), .temperature = 280 + 15.0 * double(i)});
  const GrayExchange e = gray_exchange(f, bodies);
  const GrayBalance balance = gray_balance(f, bodies, 0);
  for (size_t i = 0; i < f.size(); ++i) {
    double heat = 0;
    for (size_t j = 0; j < f.size(); ++j)
      heat += e.script_f[i * e.size + j] * kStefanBoltzmann *
              (std::pow(bodies[i].temperature, 4) - std::pow(bodies[j].temperature, 4));
    heat += e.escaped[i] * bodies[i].emissivity * kStefanBoltzmann * std::pow(bodies[i].temperature, 4);
    EXPECT_NEAR(balance.fluxes[i], heat, 1e-9 * kStefanBoltzmann * std::pow(500, 4)) << i;
  }
}

TEST(GrayBody, RefusesWhatHasNoBalance) {
  EXPECT_THROW(gray_balance(plates(), {{.flux = 1}, {.flux = -1}}, 0), Error) << "any temperature would do";
  EXPECT_THROW(gray_balance(plates(), {{.temperature = 1}, {}}, 0), Error);
  EXPECT_THROW(gray_balance(plates(), {{.temperature = 1, .flux = 1}, {.temperature = 1}}, 0), Error);
  EXPECT_THROW(gray_exchange(plates(), {{.emissivity = 0}, {}}), Error);
}

}  // namespace
}  // namespace aktina
