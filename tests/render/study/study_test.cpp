// Whole studies of a small ball.
#include "aktina/render/study/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "aktina/base/error.h"
#include "aktina/base/file.h"
#include "aktina/base/parallel.h"
#include "aktina/render/catalogue.h"
#include "render/study/scenes.h"

namespace aktina {
namespace {

StudyOptions small(const std::string& family, std::vector<std::string> methods = {}) {
  StudyOptions options;
  options.family = family, options.methods = std::move(methods);
  options.width = 96, options.height = 72, options.samples = 4, options.rounds = 1, options.growth = false;
  return options;
}

Study run(const StudyOptions& options, const Scene& scene = test::ball()) {
  Progress progress;
  return study(scene, options, progress);
}

const MethodStudy& method(const Study& s, const std::string& choice) {
  for (const MethodStudy& m : s.methods)
    if (m.choice == choice) return m;
  throw std::logic_error(choice);
}

TEST(Study, TakesEveryMethodFromTheCatalogue) {
  const Study s = run(small("shading"));
  ASSERT_EQ(s.methods.size(), find_family("shading").methods.size());
  for (const MethodStudy& m : s.methods) {
    if (!m.failure.empty()) continue;
    EXPECT_TRUE(std::isfinite(m.quality.rmse)) << m.id;
    EXPECT_EQ(m.quality.not_finite, 0u) << m.id;
    ASSERT_FALSE(m.cost.times.empty()) << m.id;
    EXPECT_GT(m.cost.times[0].seconds, 0) << m.id;
    EXPECT_GT(m.cost.ns_per_pixel, 0) << m.id;
  }
  EXPECT_TRUE(s.report.complete);
}

TEST(Study, TheReferenceDoesNotDifferFromItself) {
  const Study s = run(small("shading", {"phong", "gouraud"}));
  EXPECT_EQ(method(s, "phong").quality.rmse, 0);
  EXPECT_EQ(method(s, "phong").quality.flip, 0);
  EXPECT_EQ(method(s, "phong").quality.flicker, 0);
  EXPECT_GT(method(s, "gouraud").quality.rmse, 0);
  EXPECT_GT(method(s, "gouraud").quality.highlight_rmse, method(s, "gouraud").quality.rmse);
}

TEST(Study, FacetsJumpAndGouraudHasKinks) {
  StudyOptions options = small("shading", {"flat", "gouraud", "phong"});
  options.illumination = "lambert", options.width = 320, options.height = 240;
  const Study s = run(options);
  EXPECT_GT(method(s, "flat").quality.edge_jump, 5 * method(s, "gouraud").quality.edge_jump);
  EXPECT_GT(method(s, "gouraud").quality.mach_band, 1.2 * method(s, "phong").quality.mach_band);
}

TEST(Study, EvaluationsAreWhereTheMethodDoesThem) {
  const Study s = run(small("shading", {"gouraud", "phong"}));
  EXPECT_EQ(method(s, "gouraud").cost.pixel_evaluations, 0);
  EXPECT_GT(method(s, "gouraud").cost.setup_evaluations, 0);
  EXPECT_GE(method(s, "phong").cost.pixel_evaluations, 1);
  EXPECT_EQ(method(s, "phong").cost.setup_evaluations, 0);
}

TEST(Study, AReferenceOfTheCallersOwn) {
  StudyOptions options = small("shading", {"gouraud"});
  options.reference = "gouraud";
  EXPECT_EQ(run(options).methods[0].quality.rmse, 0);
}

TEST(Study, AnyFamilyThatPicturesCanCompare) {
  const Study illumination = run(small("illumination", {"phong", "lambert", "ggx"}));
  EXPECT_EQ(method(illumination, "phong").quality.rmse, 0);
  EXPECT_GT(method(illumination, "lambert").quality.highlight_rmse, 0.02) << "no highlights at all";
  const Study normals = run(small("normals"));
  for (const MethodStudy& m : normals.methods) EXPECT_LT(m.quality.rmse, 0.1) << m.id << ": near those of the ball";
  StudyOptions traced = small("integrator", {"direct"});
  traced.width = 24, traced.height = 18;
  EXPECT_LT(run(traced).methods[0].quality.rmse, 0.2) << "a ball alone in space is lit directly";
}

TEST(Study, EnergyOfIlluminationModels) {
  const Study s = run(small("illumination", {"lambert", "phong"}));
  const double kd = double(luminance(Rgb(0.6f, 0.4f, 0.2f)));
  const Energy matt = method(s, "lambert").energy;
  EXPECT_NEAR(matt.albedo_0, kd, 2e-3);
  EXPECT_NEAR(matt.albedo_85, kd, 2e-2);
  EXPECT_NEAR(matt.reciprocity_error, 0, 1e-5);
  const Energy shiny = method(s, "phong").energy;
  EXPECT_NEAR(shiny.albedo_0, kd + 0.5 * 2 / (20 + 1), 3e-3)
      << "ks times the integral of cos^n / pi over the hemisphere";
  EXPECT_LT(shiny.albedo_85, shiny.albedo_0) << "half of the lobe is below the horizon";
  EXPECT_GT(shiny.reciprocity_error, 0.1);
}

TEST(Study, TheFrontHoldsWhatNothingBeats) {
  const Study s = run(small("shading", {"flat", "gouraud", "phong"}));
  EXPECT_TRUE(method(s, "phong").best) << "without error";
  for (const MethodStudy& m : s.methods) {
    bool beaten = false;
    for (const MethodStudy& o : s.methods)
      beaten = beaten || (o.quality.rmse < m.quality.rmse && o.cost.times[0].seconds < m.cost.times[0].seconds);
    EXPECT_EQ(m.best, !beaten) << m.id;
  }
}

TEST(Study, GrowthHasAPointForEachSize) {
  StudyOptions options = small("shading", {"gouraud"});
  options.growth = true;
  const Growth growth = run(options).methods[0].growth;
  ASSERT_EQ(growth.over_triangles.size(), 3u);
  EXPECT_EQ(growth.over_triangles[1].triangles, 4 * growth.over_triangles[0].triangles);
  ASSERT_EQ(growth.over_pixels.size(), 3u);
  EXPECT_EQ(growth.over_pixels[2].pixels, 16 * growth.over_pixels[0].pixels);
  EXPECT_LT(growth.error_over_triangles, -0.4) << "Gouraud comes nearer to Phong with finer triangles";
}

TEST(Study, ClaimsHaveSourcesAndVerdicts) {
  const std::string bibliography = read_text_file(std::string(AKTINA_SOURCE_DIR) + "/docs/references.bib");
  const Study s = run(small("shading"));
  size_t claims = 0;
  for (const MethodStudy& m : s.methods)
    for (const ClaimResult& c : m.claims) {
      ++claims;
      EXPECT_THAT(bibliography, testing::HasSubstr("{" + c.source + ",")) << m.id;
      EXPECT_FALSE(c.measured.empty()) << m.id;
    }
  EXPECT_GT(claims, 8u);
  EXPECT_EQ(method(s, "seiler").claims[0].verdict, ClaimResult::Verdict::holds) << "the same polynomial as quadratic";
  EXPECT_FALSE(s.remarks.empty());
}

TEST(Study, Mistakes) {
  const auto code = [](const StudyOptions& options) {
    try {
      run(options);
    } catch (const Error& error) {
      return error.code();
    }
    ADD_FAILURE() << "no error";
    return Code::usage;
  };
  EXPECT_EQ(code(small("light")), Code::usage);
  EXPECT_EQ(code(small("shading", {"no_such"})), Code::no_such_method);
  EXPECT_EQ(code(small("shading", {"gouraud:no_such=1"})), Code::usage);
  StudyOptions options = small("shading", {"gouraud"});
  options.reference = "no_such";
  EXPECT_EQ(code(options), Code::no_such_method);
  options = small("shading", {"gouraud"}), options.samples = 3;
  EXPECT_EQ(code(options), Code::bad_param);
  options = small("shading", {"gouraud"}), options.camera = 7;
  EXPECT_EQ(code(options), Code::usage);
}

TEST(Study, StoppedBeforeItsFirstMethodHasNothingToShow) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(study(test::ball(), small("shading"), progress), Error);
}

TEST(Study, StoppedLaterKeepsWhatIsKnown) {
  Progress progress(
      [&](const ProgressState& state) {
        if (state.stage == "timing") progress.cancel();
      },
      0);
  const Study s = study(test::ball(), small("shading", {"gouraud", "phong"}), progress);
  EXPECT_FALSE(s.report.complete);
  EXPECT_GT(method(s, "gouraud").quality.rmse, 0);
}

TEST(Study, GivesTheThreadsBack) {
  set_thread_count(2);
  run(small("shading", {"gouraud"}));
  EXPECT_EQ(thread_count(), 2);
  set_thread_count(0);
}

}  // namespace
}  // namespace aktina
