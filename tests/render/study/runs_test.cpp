// Studies by runs: form factors, solvers and meshers against exact or path traced answers.
#include "aktina/render/study/runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/render/catalogue.h"
#include "aktina/render/study/claims.h"
#include "aktina/render/study/html.h"
#include "aktina/render/study/output.h"
#include "radiosity/scenes.h"

namespace aktina {
namespace {

Scene lit_room() {
  Scene scene = room(Vec3(2, 2, 3), Rgb(0.5f));
  add_quad(scene, Point3(0.7f, 1.8f, 1.2f), Vec3(0.6f, 0, 0), Vec3(0, 0, 0.6f), Rgb(0), Rgb(3000));
  add_box(scene, Point3(0.5f, 0.3f, 1), Vec3(0.6f, 0.5f, 0.6f), Rgb(0.5f));
  scene.source = "/somewhere/room.glb";
  return scene;
}

Study run(const std::string& family, std::vector<std::string> methods = {}) {
  StudyOptions options;
  options.family = family, options.methods = std::move(methods);
  Progress progress;
  return study(lit_room(), options, progress);
}

const MethodStudy& method(const Study& s, std::string_view id) {
  for (const MethodStudy& m : s.methods)
    if (m.id == id) return m;
  throw std::logic_error(std::string(id));
}

StudyRun measured(double seconds, double error) {
  StudyRun run;
  run.seconds = seconds, run.error = error;
  return run;
}

TEST(StudyByRuns, TheBestRunsAreThoseThatNothingBeats) {
  MethodStudy m;
  m.runs = {measured(4, 0.01), measured(1, 0.1), measured(2, 0.2), measured(1, 0.3), measured(8, kNotMeasured)};
  const auto best = best_runs(m, &StudyRun::seconds);
  ASSERT_EQ(best.size(), 2u);
  EXPECT_EQ(best[0]->error, 0.1);
  EXPECT_EQ(best[1]->error, 0.01);
  EXPECT_NEAR(error_at(m, &StudyRun::seconds, 2), std::sqrt(0.1 * 0.01), 1e-12) << "half way in the logarithms";
  EXPECT_EQ(error_at(m, &StudyRun::seconds, 9), 0.01);
  EXPECT_TRUE(std::isnan(error_at(m, &StudyRun::seconds, 0.5)));
}

TEST(StudyByRuns, FormFactorsComeNearTheExactOnes) {
  const Study s = run("formfactor", {"contour", "ray_cast", "hemicube"});
  for (const MethodStudy& m : s.methods) {
    ASSERT_FALSE(m.runs.empty()) << m.id << ": " << m.failure;
    const double least = best_runs(m, &StudyRun::seconds).back()->error;
    EXPECT_LT(least, 5e-3) << m.id;
    for (const StudyRun& one : m.runs) EXPECT_GE(one.largest_error, one.error) << one.name();
  }
  EXPECT_TRUE(s.report.complete);
}

TEST(StudyByRuns, SolversBalanceTheLightOfTheMatrix) {
  const Study s = run("radiosity", {"jacobi"});
  for (const MethodStudy& m : s.methods) {
    ASSERT_GE(m.runs.size(), 5u) << m.failure;
    EXPECT_GT(m.runs.front().off_balance, m.runs[4].off_balance) << m.id;
    EXPECT_LT(m.runs[4].off_balance, 5e-3) << m.id;
    EXPECT_LT(m.runs[4].error, 0.05) << m.id << ": against path tracing";
  }
}

TEST(StudyByRuns, FinerMeshesAreNearer) {
  const Study s = run("mesher", {"uniform"});
  const std::vector<StudyRun>& runs = method(s, "uniform").runs;
  ASSERT_GE(runs.size(), 3u);
  EXPECT_GT(runs.back().size, 3 * runs.front().size);
  EXPECT_LT(runs.back().error, 0.7 * runs.front().error);
}

TEST(StudyByRuns, ClaimsAreJudged) {
  const Study s = run("formfactor", {"monte_carlo", "hybrid"});
  for (const MethodStudy& m : s.methods) {
    ASSERT_EQ(m.claims.size(), 1u) << m.id;
    EXPECT_EQ(m.claims[0].verdict, ClaimResult::Verdict::holds) << m.id << ": " << m.claims[0].measured;
  }
}

TEST(StudyByRuns, EveryClaimIsOnAMethodOfTheCatalogue) {
  for (const Claim& claim : run_claims()) {
    const auto& methods = find_family(claim.family).methods;
    EXPECT_TRUE(std::any_of(methods.begin(), methods.end(), [&](const MethodInfo* m) { return m->id == claim.method; }))
        << claim.method;
  }
}

TEST(StudyByRuns, TheFilesHoldEachRun) {
  const std::vector<Study> made = {run("formfactor", {"hemicube", "analytic"})};
  const auto json = nlohmann::json::parse(study_json(made));
  const auto& first = json["studies"][0]["methods"][0];
  ASSERT_EQ(first["runs"].size(), made[0].methods[0].runs.size());
  for (const RunColumn& column : run_columns()) EXPECT_TRUE(first["runs"][0].contains(column.name)) << column.name;
  const std::string page = study_html(made);
  for (const MethodStudy& m : made[0].methods)
    for (const StudyRun* best : best_runs(m, &StudyRun::seconds))
      EXPECT_THAT(page, testing::HasSubstr(best->name())) << "the chart's points are named";
}

TEST(StudyByRuns, ThereIsNoReferenceToChoose) {
  StudyOptions options;
  options.family = "mesher", options.reference = "quadtree";
  Progress progress;
  EXPECT_THROW(study(lit_room(), options, progress), Error);
}

}  // namespace
}  // namespace aktina
