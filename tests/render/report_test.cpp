#include "aktina/render/report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace aktina {
namespace {

TEST(Report, JsonHoldsWhatWasRecorded) {
  Report report;
  report.settings = "render room.glb";
  report.seed = 7;
  report.scene_file = "r\xff.glb";  // not UTF-8
  report.scene_hash = "0123456789abcdef";
  report.time("trace", 1.5);
  report.count("rays", 1e6, "rays");
  report.warnings.add("two degenerate triangles", 2);
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["scene"]["hash"], "0123456789abcdef");
  EXPECT_EQ(json["scene"]["file"], "r\uFFFD.glb");
  EXPECT_EQ(json["timings"]["trace"], 1.5);
  EXPECT_EQ(json["counts"]["rays"]["value"], 1e6);
  EXPECT_EQ(json["warnings"][0]["count"], 2);
  EXPECT_EQ(json["complete"], true);
}

TEST(Report, OutputsRecordNoTimings) {
  Report a, b;
  a.time("trace", 1), b.time("trace", 2);
  a.threads = 1, b.threads = 2;
  EXPECT_EQ(provenance(a), provenance(b)) << "the same settings give the same bytes";
}

}  // namespace
}  // namespace aktina
