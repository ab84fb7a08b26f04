#include <gtest/gtest.h>

#include <cstring>
#include <regex>

#include "aktina/export/export.h"
#include "export/lit_scene.h"
#include "test_files.h"

namespace aktina {
namespace {

/// Bytes of a DataArray by VTK's rules: its offset counts from behind the underscore; eight bytes give the length.
template <class T>
std::vector<T> array(const std::string& file, const std::string& section, const std::string& name) {
  const size_t from = file.find("<" + section), to = file.find("</" + section + ">");
  const std::string part = file.substr(from, to - from);
  std::smatch match;
  const std::regex expression("Name=\"" + name + "\" NumberOfComponents=\"\\d\" format=\"appended\" offset=\"(\\d+)\"");
  if (!std::regex_search(part, match, expression)) return {};
  const std::string mark = "<AppendedData encoding=\"raw\">\n_";
  const size_t at = file.find(mark) + mark.size() + std::stoul(match[1]);
  uint64_t bytes = 0;
  std::memcpy(&bytes, file.data() + at, 8);
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), file.data() + at + 8, bytes);
  return values;
}

TEST(Vtu, CellsPointsAndValues) {
  const test::TemporaryFolder folder;
  Solution solution = test::row_of_patches({100, 250});
  solution.mesh.patches[1] = {4, 5, 6, 6};  // a triangle
  write_vtu(folder / "s.vtu", solution, {{"Scene <&\">", "ü"}});
  const std::string file = read_text_file(folder / "s.vtu");
  EXPECT_NE(file.find("NumberOfPoints=\"8\" NumberOfCells=\"2\""), file.npos);
  EXPECT_NE(file.find("Name=\"Scene &lt;&amp;&quot;&gt;\" NumberOfTuples=\"1\" format=\"ascii\">195 188 0<"),
            file.npos);
  EXPECT_EQ(array<int64_t>(file, "Cells", "connectivity"), (std::vector<int64_t>{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(array<int64_t>(file, "Cells", "offsets"), (std::vector<int64_t>{4, 7}));
  EXPECT_EQ(array<uint8_t>(file, "Cells", "types"), (std::vector<uint8_t>{9, 5}));
  EXPECT_EQ(array<float>(file, "CellData", "irradiance"), (std::vector<float>{100, 100, 100, 250, 250, 250}));
  EXPECT_EQ(array<float>(file, "CellData", "radiosity"), (std::vector<float>{50, 50, 50, 125, 125, 125}));
  EXPECT_EQ(array<float>(file, "CellData", "area"), (std::vector<float>{1, 1}));
  EXPECT_FLOAT_EQ(array<float>(file, "CellData", "illuminance")[1], 250);
  EXPECT_EQ(array<float>(file, "PointData", "irradiance").size(), 24u);
  const auto points = array<float>(file, "Points", "Points");
  ASSERT_EQ(points.size(), 24u);
  EXPECT_EQ(points[12], 1);
}

TEST(Vtu, ASolutionWithoutPatches) {
  const test::TemporaryFolder folder;
  write_vtu(folder / "s.vtu", {});
  EXPECT_NE(read_text_file(folder / "s.vtu").find("NumberOfCells=\"0\""), std::string::npos);
}

}  // namespace
}  // namespace aktina
