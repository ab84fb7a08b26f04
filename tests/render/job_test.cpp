#include "aktina/render/job.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/base/parallel.h"
#include "render/job_scenes.h"

namespace aktina {
namespace {

using test::lit_floor;

RenderOptions small(const std::string& method) {
  RenderOptions options;
  options.method = method;
  options.width = 24, options.height = 16, options.samples = 4;
  return options;
}

/// Of the error that follows from one change to options that are right.
Code code_of(const Scene& scene, const std::function<void(RenderOptions&)>& change) {
  RenderOptions options = small("raster");
  change(options);
  Progress progress;
  try {
    render(scene, options, progress);
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return Code::usage;
}

TEST(RenderJob, SizeComesFromTheCamera) {
  Scene scene = lit_floor();
  scene.cameras[0].aspect = 2;
  Progress progress;
  const auto size = [&](int width, int height) {
    RenderOptions options = small("raster");
    options.width = width, options.height = height, options.samples = 1;
    const LayeredImage picture = render(scene, options, progress).picture;
    return std::pair(picture.layers[0].image.width, picture.layers[0].image.height);
  };
  EXPECT_EQ(size(0, 0), std::pair(960, 480));
  EXPECT_EQ(size(100, 0), std::pair(100, 50));
  EXPECT_EQ(size(0, 100), std::pair(200, 100));
  EXPECT_EQ(size(30, 40), std::pair(30, 40));
}

TEST(RenderJob, ReportSaysWhatWasDone) {
  Progress progress;
  const Scene scene = lit_floor();
  const Report report = render(scene, small("raster"), progress).report;
  EXPECT_TRUE(report.complete);
  EXPECT_EQ(report.scene_file, "floor.glb");
  EXPECT_EQ(report.scene_hash, hash(scene).text());
  EXPECT_NE(report.settings.find("render floor.glb --method raster"), std::string::npos);
  EXPECT_EQ(report.warnings.items().at(0).text, "a warning of the import");
  EXPECT_FALSE(report.timings.empty());
  EXPECT_FALSE(report.counts.empty());
}

TEST(RenderJob, Mistakes) {
  const Scene scene = lit_floor();
  EXPECT_EQ(code_of(scene, [](RenderOptions& o) { o.method = "no_such"; }), Code::no_such_method);
  EXPECT_EQ(code_of(scene, [](RenderOptions& o) { o.shading = "no_such"; }), Code::no_such_method);
  EXPECT_EQ(code_of(scene, [](RenderOptions& o) { o.width = o.height = 100000; }), Code::limit);
  EXPECT_EQ(code_of(scene, [](RenderOptions& o) { o.width = -1; }), Code::limit);
  EXPECT_EQ(code_of(scene, [](RenderOptions& o) { o.camera = 1; }), Code::usage);
  EXPECT_EQ(code_of(scene, [](RenderOptions& o) { o.layers = {"indirect"}; }), Code::usage);
  EXPECT_EQ(code_of({}, [](RenderOptions&) {}), Code::usage) << "no camera";
}

TEST(RenderJob, LayersAreThoseAskedFor) {
  Progress progress;
  RenderOptions options = small("raster");
  options.layers = {"N", "Z"};
  const LayeredImage picture = render(lit_floor(), options, progress).picture;
  ASSERT_EQ(picture.layers.size(), 3u);
  EXPECT_EQ(picture.layers[0].name, "");
  EXPECT_TRUE(picture.find("N"));
  EXPECT_TRUE(picture.find("Z"));
}

TEST(RenderJob, SameBytesForAnyNumberOfThreads) {
  for (const char* const method : test::kRenderMethods) {
    const auto pixels = [&](int threads) {
      set_thread_count(threads);
      Progress progress;
      return render(lit_floor(), small(method), progress).picture.layers[0].image.pixels;
    };
    EXPECT_EQ(pixels(1), pixels(3)) << method;
  }
  set_thread_count(0);
}

}  // namespace
}  // namespace aktina
