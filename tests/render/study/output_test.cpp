// The files of a study.
#include "aktina/render/study/output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "aktina/base/error.h"
#include "aktina/render/study/html.h"
#include "render/study/scenes.h"
#include "test_files.h"

namespace aktina {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::vector<Study>& studies() {
  static const std::vector<Study> made = [] {
    StudyOptions options;
    options.methods = {"gouraud", "quadratic:perspective=1", "phong"};
    options.width = 64, options.height = 48, options.samples = 1, options.rounds = 1;
    Scene scene = test::ball();
    scene.source = "a <b> & \"c\".glb";
    Progress progress;
    return std::vector<Study>{study(scene, options, progress)};
  }();
  return made;
}

size_t count(const std::string& text, const std::string& word) {
  size_t n = 0;
  for (size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(StudyOutput, JsonHoldsEveryNumber) {
  const auto json = nlohmann::json::parse(study_json(studies()));
  EXPECT_EQ(json["schema_version"], kStudySchema);
  const auto& s = json["studies"][0];
  EXPECT_EQ(s["reference"], "phong");
  ASSERT_EQ(s["methods"].size(), 3u);
  EXPECT_EQ(s["methods"][1]["method"], "quadratic:perspective=1");
  EXPECT_EQ(s["methods"][2]["quality"]["rmse"], 0);
  EXPECT_TRUE(s["methods"][2]["quality"]["psnr"].is_null()) << "infinite";
  for (const auto& column : json["columns"])
    EXPECT_TRUE(s["methods"][0][std::string(column["group"])].contains(std::string(column["name"]))) << column;
}

TEST(StudyOutput, CsvHasALineAMethodAndAsManyFieldsAsNames) {
  const std::string text = study_csv(studies());
  std::istringstream lines(text);
  std::string head, line;
  std::getline(lines, head);
  size_t rows = 0;
  for (; std::getline(lines, line); ++rows)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(head.begin(), head.end(), ',')) << line;
  EXPECT_EQ(rows, 3u);
}

TEST(StudyOutput, ThePageNeedsNothingElse) {
  const std::string page = study_html(studies());
  EXPECT_THAT(page, HasSubstr("<meta charset='utf-8'>"));
  for (const char* word : {"http:", "https:", "<link", "<script src", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(word)));
  EXPECT_EQ(count(page, "src='data:image/png;base64,"), 1 + 3 * 3u) << "the reference, and three pictures a method";
  EXPECT_THAT(page, HasSubstr("class='front'"));
}

TEST(StudyOutput, ThePageIsWellFormed) {
  const std::string page = study_html(studies());
  for (const char* tag : {"html", "head", "body", "main", "section", "table", "tr", "svg", "figure", "div", "p"}) {
    const std::string open = std::string("<") + tag, close = std::string("</") + tag + ">";
    EXPECT_EQ(count(page, open + ">") + count(page, open + " "), count(page, close)) << tag;
  }
  EXPECT_THAT(page, HasSubstr("a &lt;b&gt; &amp; &quot;c&quot;.glb")) << "names are text, not markup";
}

TEST(StudyOutput, AChartOfManyMethodsInOnePlaceKeepsItsLabelsApart) {
  Study crowded = studies()[0];
  for (int i = 0; i < 40; ++i) {
    crowded.methods.push_back(crowded.methods[0]);
    crowded.methods.back().quality.rmse = 0.01 + 1e-7 * i;
  }
  const std::string chart = html_chart(crowded);
  std::set<std::string> heights;
  const std::regex label("<circle[^>]*/><text x='[^']*' y='([^']*)'");
  for (std::sregex_iterator at(chart.begin(), chart.end(), label), end; at != end; ++at) heights.insert((*at)[1]);
  EXPECT_EQ(count(chart, "<circle"), 43u);
  EXPECT_GE(heights.size(), 41u);
}

TEST(StudyOutput, NumbersAreShort) {
  EXPECT_EQ(shown(0), "0");
  EXPECT_EQ(shown(kNotMeasured), "–");
  EXPECT_EQ(shown(0.123456), "0.123");
  EXPECT_EQ(shown(1234.5), "1234");
  EXPECT_EQ(shown(1.23e-5), "1.2e-05");
}

TEST(StudyOutput, AFolderIsReplacedOnlyWhereAStudyWroteIt) {
  const test::TemporaryFolder place;
  const Path folder = place.path() / "report";
  EXPECT_EQ(write_study(folder, studies()).size(), 3u);
  EXPECT_EQ(write_study(folder / "", studies()).size(), 3u) << "again, and with a slash";
  EXPECT_TRUE(std::filesystem::exists(folder / "report.html"));
  std::ofstream(folder / "mine.txt") << "x";
  EXPECT_THROW(write_study(folder, studies()), Error);
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.txt"));
  EXPECT_THROW(check_study_folder(place.path() / "no" / "such"), Error);
  EXPECT_THROW(check_study_folder(folder / "mine.txt"), Error);
  size_t entries = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(place.path())) ++entries;
  EXPECT_EQ(entries, 1u) << "nothing half-written is left";
}

}  // namespace
}  // namespace aktina
