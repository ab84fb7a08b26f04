// A run that goes on from any checkpoint ends with the bytes of one that was never interrupted.
#include "aktina/radiosity/checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "aktina/base/error.h"
#include "aktina/base/hash.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/solver.h"
#include "radiosity/scenes.h"
#include "test_files.h"

namespace aktina {
namespace {

using testing::HasSubstr;

/// Lamp, emitter and a box: every stage has something to do.
Scene lit_room() {
  Scene scene = room({2, 2, 2}, Rgb(0.8f, 0.5f, 0.4f));
  add_quad(scene, {0.7f, 1.999f, 0.7f}, {0.6f, 0, 0}, {0, 0, 0.6f}, Rgb(0), Rgb(100));
  add_box(scene, {0.5f, 0, 0.5f}, {0.5f, 0.8f, 0.5f}, Rgb(0.7f));
  scene.lights.push_back({"lamp", PointLight{{1, 1, 1}, Intensity(Rgb(20)), {}}, -1});
  return scene;
}

RadiosityOptions options_of(std::string_view solver) {
  RadiosityOptions options{.solver = std::string(solver), .patch_size = 0.5, .tolerance = 1e-3, .target_error = 0.02};
  return options;
}

RadiosityOptions few_steps() {
  RadiosityOptions options = options_of("progressive");
  options.most_steps = 3;
  return options;
}

std::vector<uint8_t> bytes_of(const Solution& solution, const test::TemporaryFolder& folder) {
  save_solution(folder / "solution.aktina", solution);
  return read_file(folder / "solution.aktina");
}

/// Solves with a checkpoint at every opportunity, and keeps a copy of each file that there ever was.
std::vector<Path> checkpoints_of(const Scene& scene, RadiosityOptions options, const test::TemporaryFolder& folder) {
  const Path file = folder / "run.checkpoint";
  std::filesystem::remove(file);
  options.checkpoint = {.file = file, .seconds = 0};
  std::vector<Path> copies;
  std::set<uint64_t> known;
  Progress progress(
      [&](const ProgressState&) {
        if (!std::filesystem::exists(file)) return;
        const std::vector<uint8_t> bytes = read_file(file);
        Hash64 hash;
        hash.add(std::as_bytes(std::span(bytes)));
        if (!known.insert(hash.value()).second) return;
        copies.push_back(folder / (options.solver + std::to_string(copies.size())));
        write_file(copies.back(), bytes);
      },
      0);
  solve_radiosity(scene, options, &progress);
  copies.push_back(file);
  return copies;
}

TEST(Checkpoint, EverySolverGoesOnFromEachAsIfNeverInterrupted) {
  const test::TemporaryFolder folder;
  const Scene scene = lit_room();
  for (const auto* row : solvers()) {
    RadiosityOptions options = options_of(row->info.id);
    const std::vector<uint8_t> whole = bytes_of(solve_radiosity(scene, options), folder);
    const std::vector<Path> copies = checkpoints_of(scene, options, folder);
    ASSERT_GE(copies.size(), 2U) << row->info.id;
    const size_t step = std::max<size_t>(1, copies.size() / 6);
    for (size_t i = 0; i < copies.size(); i += step) {
      options.checkpoint = {.file = copies[i], .seconds = 1e9, .resume = true};
      EXPECT_EQ(bytes_of(solve_radiosity(scene, options), folder), whole)
          << row->info.id << " from checkpoint " << i << " of " << copies.size();
    }
  }
}

TEST(Checkpoint, MeshesThatAreRefinedOnTheWayGoOnToo) {
  const test::TemporaryFolder folder;
  RadiosityOptions options = options_of("matrix");
  options.mesher = "quadtree";
  const std::vector<uint8_t> whole = bytes_of(solve_radiosity(lit_room(), options), folder);
  const std::vector<Path> copies = checkpoints_of(lit_room(), options, folder);
  for (size_t i = 0; i < copies.size(); i += std::max<size_t>(1, copies.size() / 6)) {
    options.checkpoint = {.file = copies[i], .seconds = 1e9, .resume = true};
    ASSERT_EQ(bytes_of(solve_radiosity(lit_room(), options), folder), whole) << i << " of " << copies.size();
  }
}

TEST(Checkpoint, FormFactorsByNumbersGoOnToo) {
  const test::TemporaryFolder folder;
  Scene scene = room({2, 2, 2}, Rgb(0.6f), Rgb(10));
  for (const char* solver : {"stochastic_jacobi", "progressive", "matrix"}) {
    RadiosityOptions options = options_of(solver);
    options.formfactor = "analytic";
    const std::vector<uint8_t> whole = bytes_of(solve_radiosity(scene, options), folder);
    for (const Path& copy : checkpoints_of(scene, options, folder)) {
      options.checkpoint = {.file = copy, .seconds = 1e9, .resume = true};
      ASSERT_EQ(bytes_of(solve_radiosity(scene, options), folder), whole) << solver;
    }
  }
}

TEST(Checkpoint, ARunThatGoesOnDoesNotBeginAgain) {
  const test::TemporaryFolder folder;
  RadiosityOptions options = options_of("progressive");
  uint64_t steps = 0;
  options.each_step = [&](const RadiosityOptions::Step& step) {
    if (step.step == 20) throw Error(Code::cancelled, "", "power failure");
  };
  options.checkpoint = {.file = folder / "a", .seconds = 0};
  EXPECT_THROW(solve_radiosity(lit_room(), options), Error);
  options.checkpoint.resume = true;
  options.each_step = [&](const RadiosityOptions::Step& step) {
    if (steps == 0) steps = step.step;
  };
  solve_radiosity(lit_room(), options);
  EXPECT_EQ(steps, 20U);
}

std::string refusal(const Scene& scene, const RadiosityOptions& options) {
  try {
    solve_radiosity(scene, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::bad_input);
    return error.what();
  }
  return "not refused";
}

TEST(Checkpoint, OfAnotherSceneOrOtherSettingsIsRefused) {
  const test::TemporaryFolder folder;
  RadiosityOptions options = few_steps();
  options.checkpoint = {.file = folder / "a", .seconds = 0};
  solve_radiosity(lit_room(), options);
  options.checkpoint.resume = true;
  Scene other = lit_room();
  other.materials[0].base_colour.r *= 0.999f;
  EXPECT_THAT(refusal(other, options), HasSubstr("another scene"));
  options.tolerance = 0.0010001;
  EXPECT_THAT(refusal(lit_room(), options), HasSubstr("other settings"));
  options = options_of("matrix");
  options.checkpoint = {.file = folder / "a", .resume = true};
  EXPECT_THAT(refusal(lit_room(), options), HasSubstr("solver=progressive"));
}

TEST(Checkpoint, DamagedIsRefused) {
  const test::TemporaryFolder folder;
  RadiosityOptions options = few_steps();
  options.checkpoint = {.file = folder / "a", .seconds = 0};
  solve_radiosity(lit_room(), options);
  const std::vector<uint8_t> good = read_file(folder / "a");
  options.checkpoint.resume = true;
  for (const size_t length : {size_t(0), size_t(7), size_t(16), size_t(200), good.size() / 2, good.size() - 1}) {
    write_file(folder / "a", std::span(good).first(length));
    EXPECT_THAT(refusal(lit_room(), options), Not(HasSubstr("not refused"))) << length;
  }
  for (const size_t at : {size_t(3), size_t(7), size_t(12), size_t(40), good.size() / 2, good.size() - 1}) {
    std::vector<uint8_t> bad = good;
    bad[at] ^= 4;
    write_file(folder / "a", bad);
    EXPECT_THAT(refusal(lit_room(), options), Not(HasSubstr("not refused"))) << at;
  }
}

TEST(Checkpoint, ReplacesNoOtherFile) {
  const test::TemporaryFolder folder;
  write_file(folder / "model.glb", "something dear");
  RadiosityOptions options = options_of("progressive");
  options.checkpoint.file = folder / "model.glb";
  EXPECT_THAT(refusal(lit_room(), options), HasSubstr("is not replaced"));
  EXPECT_EQ(read_text_file(folder / "model.glb"), "something dear");
}

TEST(Checkpoint, IsThereWhenItsTimeHasComeAndNotBefore) {
  const test::TemporaryFolder folder;
  Checkpoint late({.file = folder / "late", .seconds = 1e9}, "scene", "settings", nullptr);
  Checkpoint soon({.file = folder / "soon", .seconds = 0}, "scene", "settings", nullptr);
  int value = 3;
  for (Checkpoint* c : {&late, &soon}) CheckpointPart(c, "part", [&](Archive& a) { a(value); }).save_when_due();
  EXPECT_FALSE(std::filesystem::exists(folder / "late"));
  EXPECT_TRUE(std::filesystem::exists(folder / "soon"));
}

TEST(KeptLoop, DoesEachItemOnceHoweverOftenItIsEnded) {
  const test::TemporaryFolder folder;
  std::vector<int> visits;
  for (int run = 0; run < 6; ++run) {
    Progress progress;
    Checkpoint checkpoint({.file = folder / "a", .seconds = 0, .resume = true}, "scene", "settings", &progress);
    KeptList<int> list(&checkpoint, "list", 10);
    EXPECT_EQ(list.loop.done(), std::min(2U * unsigned(run), 10U));
    list.loop.run(10, 2, &progress, [&](size_t begin, size_t end) {
      if (begin == 2 * size_t(run) + 2) return progress.cancel();  // in the middle of the second block of this run
      for (size_t i = begin; i < end; ++i) ++list.values[i];
    });
    visits = list.values;
  }
  EXPECT_THAT(visits, testing::Each(1));
}

}  // namespace
}  // namespace aktina
