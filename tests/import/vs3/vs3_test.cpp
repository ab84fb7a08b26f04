#include "aktina/import/vs3/vs3.h"

#include <gtest/gtest.h>

#include "aktina/base/error.h"

namespace aktina {
namespace {

constexpr std::string_view kFile = R"(T  a title
C  encl=1 eps=1e-4
F  3
! comment
V 1 0 0 0
V 2 1 0 0   ! more
V 3 1 1 0
V 4 0 1 0
S 1  1 2 3 4  0 0 0.9 floor
o 2  4 3 2 0  0 0 0.5 screen
s 3  1 2 3 0  0 1 0.25
End of data
S 9 what follows is not read
)";

TEST(Vs3, SurfacesWithNamesEmissivitiesAndParts) {
  const Vs3 file = read_vs3(kFile, "a.vs3");
  EXPECT_EQ(file.title, "a title");
  ASSERT_EQ(file.surfaces.size(), 3U);
  EXPECT_EQ(file.surfaces[0].name, "floor");
  EXPECT_EQ(file.surfaces[0].corners.size(), 4U);
  EXPECT_EQ(file.surfaces[0].corners[2], Point3d(1, 1, 0));
  EXPECT_EQ(file.surfaces[1].kind, Vs3::Kind::obstruction);
  EXPECT_EQ(file.surfaces[1].corners.size(), 3U) << "a fourth corner of 0: a triangle";
  EXPECT_EQ(file.surfaces[2].combine, 1);
  EXPECT_EQ(file.surfaces[2].emissivity, 0.25);
  EXPECT_EQ(file.surfaces[2].name, "3") << "its number, where it has no name";
}

TEST(Vs3, FaultsNameTheirLine) {
  const auto refused = [](std::string_view from, std::string_view to) {
    std::string text(kFile);
    text.replace(text.find(from), from.size(), to);
    try {
      read_vs3(text, "a.vs3");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused("1 2 3 4  0", "1 2 3 7  0").find("a.vs3:9"), std::string::npos);
  EXPECT_NE(refused("0 1 0.25", "0 8 0.25").find("surface 8"), std::string::npos);
  EXPECT_NE(refused("F  3", "F  3a").find("only F 3"), std::string::npos);
  EXPECT_NE(refused("V 2 1", "V 1 1").find("twice"), std::string::npos);
  EXPECT_NE(refused("V 2 1", "V 2 nan").find("no number"), std::string::npos);
  EXPECT_NE(refused("V 2 1", "X 2 1").find("begins no line"), std::string::npos);
  EXPECT_THROW(read_vs3("", "a.vs3"), Error);
}

}  // namespace
}  // namespace aktina
