#include "aktina/import/luminaire/luminaire.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/base/vec.h"
#include "test_files.h"

namespace aktina {
namespace {

Luminaire ies(const std::string& text) {
  return read_ies({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, {}, "a.ies");
}
Luminaire ldt(const std::string& text) {
  return read_eulumdat({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "a.ldt");
}
std::string error_of(const std::string& text) {
  try {
    ies(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

constexpr char kHead[] = "IESNA:LM-63-2002\n[MANUFAC] ACME\n[LUMINAIRE] Lamp\n";

TEST(Ies, FactorsMultiply) {
  const Luminaire l = ies(std::string(kHead) + "TILT=NONE\n1 1000 2 2 1 1 2 -0.1 0 0\n0.5 0.9 15\n0 180\n0\n10 10\n");
  EXPECT_EQ(l.manufacturer, "ACME");
  EXPECT_EQ(l.format, "IES LM-63-2002");
  EXPECT_NEAR(flux(*l.table), 10 * 2 * 0.5 * 0.9 * 4 * kPi, 1e-3);
  EXPECT_EQ(l.watts, 15);
  EXPECT_EQ(l.lamp_flux, 1000);
  EXPECT_EQ(l.opening.shape, LuminousOpening::Shape::ellipse);
}

constexpr char kBulb[] = "1 -1 1 2 1 1 1 1 1 0\n1 1 15\n0 180\n0\n1 1\n";

TEST(Ies, TiltFactorsAreOfTheAngleBetweenAimAndStraightDown) {
  const Luminaire l = ies(std::string(kHead) + "TILT=INCLUDE\n1\n3\n0 60 90\n1 0.9 0.8\n" + kBulb);
  EXPECT_TRUE(l.warnings.empty());
  EXPECT_NEAR(flux(*l.table), 4 * kPi, 1e-3) << "the table is of the luminaire as it was measured";
  EXPECT_NEAR(l.opening.width, 0.3048, 1e-6) << "feet";
  const auto factor = [&](double degrees) {
    const double angle = degrees * kPi / 180;
    return tilt_factor(l.tilt, {float(std::sin(angle)), float(-std::cos(angle)), 0});
  };
  EXPECT_FLOAT_EQ(factor(0), 1);
  EXPECT_NEAR(factor(30), 0.95, 1e-6);
  EXPECT_NEAR(factor(75), 0.85, 1e-6);
  EXPECT_NEAR(factor(180), 0.8, 1e-6) << "beyond the last";
  EXPECT_FLOAT_EQ(tilt_factor({}, {1, 0, 0}), 1);
}

TEST(Ies, TiltOfAFileBeside) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "lamp.tlt") << "1\n2\n0 90\n1 0.5\n";
  const std::string text = std::string(kHead) + "TILT=lamp.tlt\n" + kBulb;
  const auto read = [&](const Path& place) {
    return read_ies({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, place, "a.ies");
  };
  EXPECT_FLOAT_EQ(tilt_factor(read(folder.path()).tilt, {1, 0, 0}), 0.5f);
  EXPECT_FALSE(read("/nowhere").warnings.empty()) << "missing, and said";
  EXPECT_TRUE(read("/nowhere").tilt.angles.empty());
}

TEST(Ies, TiltsThatFallAreNotTaken) {
  const Luminaire l = ies(std::string(kHead) + "TILT=INCLUDE\n1\n2\n90 0\n1 0.9\n" + kBulb);
  EXPECT_TRUE(l.tilt.angles.empty());
  EXPECT_FALSE(l.warnings.empty());
}

TEST(Ies, QuartersAndHalvesAreCompleted) {
  const std::string line = "1 -1 1 2 3 1 2 0 0 0\n1 1 1\n0 90\n";
  const Luminaire quarter = ies("TILT=NONE\n" + line + "0 45 90\n1 1 1 2 1 3\n");
  EXPECT_FLOAT_EQ(intensity(*quarter.table, 270, 90), 3);
  EXPECT_FLOAT_EQ(intensity(*quarter.table, 225, 90), 2);
  EXPECT_FLOAT_EQ(intensity(*quarter.table, 180, 90), 1);
  const Luminaire half = ies("TILT=NONE\n" + line + "0 90 180\n1 1 1 2 1 3\n");
  EXPECT_FLOAT_EQ(intensity(*half.table, 270, 90), 2);
  EXPECT_FLOAT_EQ(intensity(*half.table, 360, 90), 1);
  const Luminaire across = ies("TILT=NONE\n" + line + "90 180 270\n1 1 1 2 1 3\n");
  EXPECT_FLOAT_EQ(intensity(*across.table, 0, 90), 2);
  EXPECT_FLOAT_EQ(intensity(*across.table, 90, 90), 1);
  EXPECT_FLOAT_EQ(intensity(*across.table, 270, 90), 3);
}

TEST(Ies, TypesAAndBKeepTheFluxOfAnEvenHemisphere) {
  for (const char* type : {"2", "3"}) {
    const Luminaire l = ies(std::string("TILT=NONE\n1 -1 1 2 2 ") + type + " 2 0 0 0\n1 1 1\n-90 90\n0 90\n5 5 5 5\n");
    EXPECT_NEAR(flux(*l.table), 5 * 2 * kPi, 0.03 * 5 * 2 * kPi);
    EXPECT_FLOAT_EQ(intensity(*l.table, 30, 40), 5);
    EXPECT_FLOAT_EQ(intensity(*l.table, 30, 140), 0);
  }
}

/// A file of type A (3) or B (2) with one bright direction: 100 cd at horizontal 30, vertical 20 degrees.
Luminaire one_direction(const char* type) {
  std::string text = std::string("TILT=NONE\n1 -1 1 19 19 ") + type + " 2 0 0 0\n1 1 1\n";
  for (int axis = 0; axis < 2; ++axis)
    for (int a = -90; a <= 90; a += 10) text += std::to_string(a) + " ";
  text += "\n";
  for (int h = -90; h <= 90; h += 10)
    for (int v = -90; v <= 90; v += 10) text += h == 30 && v == 20 ? "100 " : "0 ";
  return ies(text);
}

TEST(Ies, TypesAAndBTurnAboutTheirOwnAxes) {
  const double h = 30 * kPi / 180, v = 20 * kPi / 180;
  // x: length axis, C0; y: width axis, C90; z: straight out
  const Vec3d b(std::cos(h) * std::sin(v), std::sin(h), std::cos(h) * std::cos(v));
  const Vec3d a(std::sin(v), std::cos(v) * std::sin(h), std::cos(v) * std::cos(h));
  for (const auto& [type, bright] : {std::pair("2", b), std::pair("3", a)}) {
    const Luminaire l = one_direction(type);
    const auto towards = [&](Vec3d d) { return intensity(*l.table, {0, 0, 1}, {1, 0, 0}, Vec3(d)); };
    // the frame of intensity(): C90 is cross(c0, axis)
    const auto at = [&](double x, double y, double z) { return towards({x, -y, z}); };
    EXPECT_GT(at(bright.x, bright.y, bright.z), 60) << type << ": interpolated between the new directions";
    EXPECT_LT(at(bright.x, bright.y, bright.z), 100.1f) << type;
    EXPECT_EQ(at(-bright.x, bright.y, bright.z), 0) << type;
    EXPECT_EQ(at(bright.x, -bright.y, bright.z), 0) << type;
    const PeakIntensity most = peak(*l.table);
    EXPECT_NEAR(most.gamma, std::acos(bright.z) * 180 / kPi, 3) << type;
    EXPECT_NEAR(most.c, std::atan2(bright.y, bright.x) * 180 / kPi, 3) << type;
  }
}

TEST(Ies, HalfOfTypeBStandsForBothSides) {
  const Luminaire l = ies("TILT=NONE\n1 -1 1 3 3 2 2 0 0 0\n1 1 1\n0 45 90\n0 45 90\n1 2 3 4 5 6 7 8 9\n");
  for (const float gamma : {20.0f, 60.0f})
    for (const float c : {10.0f, 40.0f, 80.0f}) {
      const float expected = intensity(*l.table, c, gamma);
      EXPECT_NEAR(intensity(*l.table, 180 - c, gamma), expected, 1e-3f);
      EXPECT_NEAR(intensity(*l.table, 180 + c, gamma), expected, 1e-3f);
      EXPECT_NEAR(intensity(*l.table, 360 - c, gamma), expected, 1e-3f);
    }
}

TEST(Ies, FaultsSayTheirLine) {
  EXPECT_NE(error_of("").find("no TILT"), std::string::npos);
  const std::string tilt = "TILT=NONE\n";
  EXPECT_NE(error_of(tilt + "1 1 1 9999999999 1 1 1 0 0 0").find("a.ies:2: number of vertical angles"),
            std::string::npos);
  EXPECT_NE(error_of(tilt + "1 1 1 90000 90000 1 1 0 0 0").find("are claimed"), std::string::npos);
  EXPECT_NE(error_of(tilt + "1 1 nan 2 1 1 1 0 0 0").find("multiplier"), std::string::npos);
  EXPECT_NE(error_of(tilt + "1 1 1 2 1 1 1 0 0 0 1 1 1\n90 0\n0\n1 1").find("not above"), std::string::npos);
  EXPECT_NE(error_of(tilt + "1 1 1 2 1 1 1 0 0 0 1 1 1\n0 90\n0\n1").find("ends where the candela"), std::string::npos);
}

std::string eulumdat(int symmetry, int planes, const std::string& values) {
  std::string text =
      "\xef\xbb\xbf"
      "ACME\n1\n" +
      std::to_string(symmetry) + "\n" + std::to_string(planes) + "\n90\n2\n90\n\nL\xe4mp\n\n\n\n";
  for (const char* size : {"100", "100", "50", "80", "0", "0", "0", "0", "0", "100", "80", "1", "0", "1"})
    text += std::string(size) + "\n";
  text += "1\nLED\n2000\n3000\n80\n20\n";
  for (int i = 0; i < 10; ++i) text += "0\n";
  for (int i = 0; i < planes; ++i) text += std::to_string(90 * i) + "\n";
  return text + "0\n90\n" + values;
}

TEST(Eulumdat, EverySymmetry) {
  const Luminaire round = ldt(eulumdat(1, 4, "10\n20\n"));
  EXPECT_EQ(round.name, "L\u00e4mp") << "ISO 8859-1";
  EXPECT_FLOAT_EQ(intensity(*round.table, 123, 90), 40) << "cd/klm times 2000 lm";
  EXPECT_EQ(round.opening.shape, LuminousOpening::Shape::ellipse);
  const Luminaire none = ldt(eulumdat(0, 4, "1\n1\n1\n2\n1\n3\n1\n4\n"));
  EXPECT_FLOAT_EQ(intensity(*none.table, 270, 90), 8);
  const Luminaire length = ldt(eulumdat(2, 4, "1\n1\n1\n2\n1\n3\n"));
  EXPECT_FLOAT_EQ(intensity(*length.table, 270, 90), 4);
  const Luminaire across = ldt(eulumdat(3, 4, "1\n1\n1\n2\n1\n3\n"));  // C270, C0, C90
  EXPECT_FLOAT_EQ(intensity(*across.table, 270, 90), 2);
  EXPECT_FLOAT_EQ(intensity(*across.table, 180, 90), 4);
  EXPECT_FLOAT_EQ(intensity(*across.table, 90, 90), 6);
  const Luminaire both = ldt(eulumdat(4, 4, "1\n1\n1\n2\n"));
  EXPECT_FLOAT_EQ(intensity(*both.table, 270, 90), 4);
  EXPECT_FLOAT_EQ(intensity(*both.table, 180, 90), 2);
}

TEST(Luminaires, CutAndFlippedFiles) {
  const std::string files[] = {
      std::string(kHead) + "TILT=NONE\n1 -1 1 2 2 1 2 0 0 0\n1 1 1\n0 90\n0 90\n1 2 3 4\n",
      std::string("TILT=INCLUDE\n1 2 0 90 1 1\n1 -1 1 2 2 2 2 0 0 0\n1 1 1\n0 90\n0 90\n1 2 3 4\n"),
      eulumdat(4, 4, "1\n1\n1\n2\n")};
  Pcg32 random(5);
  const auto attempt = [](const std::string& text) {
    for (const auto read : {ies, ldt}) try {
        read(text);
      } catch (const Error&) {
      }
  };
  for (const std::string& file : files) {
    for (size_t i = 0; i < file.size(); ++i) attempt(file.substr(0, i));
    for (int i = 0; i < 500; ++i) {
      std::string flipped = file;
      for (uint32_t k = random.next() % 4 + 1; k-- > 0;)
        flipped[random.next() % flipped.size()] ^= char(1 << random.next() % 8);
      attempt(flipped);
    }
  }
}

TEST(Luminaires, FluxOfProfilesInCirculation) {
  AKTINA_NEEDS_THIRD_PARTY_SCENES();
  const std::pair<const char*, double> known[] = {
      {"area_light", 28351},  {"comet", 16100},         {"cylinder_wide", 7509}, {"defined_spot", 1964},
      {"jelly_fish", 6486},   {"overhead", 37084},      {"pear", 7301},          {"soft_arrow", 798},
      {"star_focused", 33.3}, {"three_lobe_vee", 4571}, {"top_post", 4294},      {"umbrella", 8686},
      {"x_arrow", 525},       {"x_arrow_soft", 231}};
  for (const auto& [name, lumens] : known) {
    const Path path = test::third_party_scenes() / "ies-renderpipeline" / (std::string(name) + ".ies");
    if (!std::filesystem::exists(path)) continue;
    EXPECT_NEAR(flux(*load_luminaire(path).table), lumens, 0.01 * lumens) << name;
  }
}

TEST(Luminaires, EveryFileOfOthersLoads) {
  AKTINA_NEEDS_THIRD_PARTY_SCENES();
  size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::third_party_scenes())) {
    const std::string extension = lower_extension(entry.path());
    if (extension != "ies" && extension != "ldt") continue;
    const Luminaire l = load_luminaire(entry.path());
    EXPECT_GT(flux(*l.table), 0) << entry.path();
    if (entry.path().parent_path().filename() == "ldt-eulumdat-py") {
      EXPECT_LT(flux(*l.table), 1.1 * l.lamp_flux) << entry.path();
    }
    ++count;
  }
  EXPECT_GT(count, 20u);
}

TEST(Luminaires, BeamAngleOfACosineEmitter) {
  PhotometricTable table{{0}, {}, {}};
  for (int i = 0; i <= 90; ++i)
    table.gamma.push_back(float(i)), table.candela.push_back(std::cos(float(i) * float(kPi / 180)));
  table.candela.back() = 0;
  EXPECT_NEAR(opening_angle(table, 0.5), 120, 0.01) << "cos 60 = 1/2";
  EXPECT_NEAR(opening_angle(table, 0.1), 2 * std::acos(0.1) * 180 / kPi, 0.02);
}

}  // namespace
}  // namespace aktina
