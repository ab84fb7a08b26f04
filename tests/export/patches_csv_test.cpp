#include <gtest/gtest.h>

#include "aktina/base/error.h"
#include "aktina/export/export.h"
#include "export/lit_scene.h"
#include "test_files.h"

namespace aktina {
namespace {

/// Records of fields, by RFC 4180; comment lines left out.
std::vector<std::vector<std::string>> parse(const std::string& text) {
  std::vector<std::vector<std::string>> records(1, {""});
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& field = records.back().back();
    if (c == '"' && quoted && text[i + 1] == '"')
      field += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      records.back().emplace_back();
    else if (!quoted && c == '\n')
      records.push_back({""});
    else if (quoted || c != '\r')
      field += c;
  }
  records.pop_back();
  std::erase_if(records, [](const auto& record) { return record[0].starts_with("# "); });
  return records;
}

TEST(PatchesCsv, OneRecordAPatchWithNamesAsTheyAre) {
  const test::TemporaryFolder folder;
  Scene scene = test::lit_square({});
  scene.nodes[0].name = "wall, \"north\"\nü #1";
  Solution solution = test::row_of_patches({100, 250});
  solution.irradiances[1] = Irradiance(Rgb(1000, 0, 0));
  write_patches_csv(folder / "p.csv", scene, solution, {{"Scene", "a\nb"}});
  const std::string text = read_text_file(folder / "p.csv");
  EXPECT_TRUE(text.starts_with("# Scene: a b\r\n"));
  const auto records = parse(text);
  ASSERT_EQ(records.size(), 3u);
  const auto column = [&](const char* name) {
    return size_t(std::find(records[0].begin(), records[0].end(), name) - records[0].begin());
  };
  for (const auto& record : records) ASSERT_EQ(record.size(), records[0].size());
  EXPECT_EQ(records[1][column("instance")], "wall, \"north\"\nü #1");
  EXPECT_EQ(records[2][column("x_m")], "1.5");
  EXPECT_EQ(records[2][column("normal_z")], "1");
  EXPECT_EQ(records[1][column("area_m2")], "1");
  EXPECT_EQ(records[1][column("exitance_g_lm_m2")], "50");
  EXPECT_EQ(records[1][column("illuminance_lx")], "100");
  EXPECT_NEAR(std::stod(records[2][column("illuminance_lx")]), 212.6, 1e-3) << "weighted as luminance";
}

TEST(PatchesCsv, UnwritableFolder) {
  EXPECT_THROW(write_patches_csv("/nowhere/p.csv", {}, test::row_of_patches({1})), Error);
}

}  // namespace
}  // namespace aktina
