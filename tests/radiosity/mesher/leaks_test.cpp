// The leak detector: gaps of known width at known places.
#include "aktina/radiosity/mesher/leaks.h"

#include <gtest/gtest.h>

#include "radiosity/scenes.h"

namespace aktina {
namespace {

Scene furnished(float lift) {
  Scene scene = room({4, 2.5f, 3}, Rgb(0.5f));
  add_box(scene, {1, lift, 1}, {0.8f, 0.6f, 0.7f}, Rgb(0.5f));
  return scene;
}

TEST(Leaks, AClosedRoomHasNone) {
  const Leaks leaks = find_leaks(room({4, 2.5f, 3}, Rgb(0.5f)));
  EXPECT_EQ(leaks.gaps, 0U);
  EXPECT_EQ(leaks.crossed_faces, 0U);
  EXPECT_TRUE(leaks.complete);
}

TEST(Leaks, ABoxThatFloatsAMillimetreHasFour) {
  const Leaks leaks = find_leaks(furnished(1e-3f));
  EXPECT_EQ(leaks.gaps, 4U) << "the edges of its lower face";
  EXPECT_NEAR(leaks.gap_length, 2 * (0.8 + 0.7), 1e-5);
  EXPECT_EQ(leaks.crossed_faces, 0U);
  ASSERT_EQ(leaks.worst.size(), 4U);
  EXPECT_NEAR(leaks.worst[0].width, 1e-3, 1e-6);
  EXPECT_NEAR(leaks.worst[0].length, 0.8, 1e-6) << "the longest first";
  EXPECT_NEAR(leaks.worst[0].place.x, 1.4, 1e-6);
  EXPECT_EQ(leaks.worst[0].other, 0U) << "the floor";
}

TEST(Leaks, ABoxThatStandsOrSinksHasNoneAndBuriesTheFloor) {
  const Leaks standing = find_leaks(furnished(0));
  EXPECT_EQ(standing.gaps, 0U);
  EXPECT_EQ(standing.crossed_faces, 1U) << "the floor";
  const Leaks sunk = find_leaks(furnished(-1e-3f));
  EXPECT_EQ(sunk.gaps, 0U);
  EXPECT_EQ(sunk.crossed_faces, 5U) << "the floor and the four sides";
}

TEST(Leaks, TooManyTrianglesAreNotExamined) {
  Scene scene = furnished(1e-3f);
  const Instance floor = scene.instances[0];
  while (triangle_count(scene) <= kMostLeakTriangles) scene.instances.insert(scene.instances.end(), 1000, floor);
  const Leaks leaks = find_leaks(scene);
  EXPECT_FALSE(leaks.complete);
  EXPECT_EQ(leaks.gaps, 0U);
}

TEST(Leaks, WiderGapsAreOpeningsUnlessAskedFor) {
  EXPECT_EQ(find_leaks(furnished(0.02f)).gaps, 0U);
  EXPECT_EQ(find_leaks(furnished(0.02f), 0.03).gaps, 4U);
}

TEST(Leaks, AWallThatEndsShortOfTheCeilingIsFound) {
  Scene scene = room({4, 2.5f, 3}, Rgb(0.5f));
  const size_t wall = add_quad(scene, {1.7f, 0, 0}, {0, 2.497f, 0}, {0, 0, 3}, Rgb(0.5f));
  const Leaks leaks = find_leaks(scene);
  ASSERT_EQ(leaks.gaps, 1U);
  EXPECT_EQ(leaks.worst[0].instance, wall);
  EXPECT_NEAR(leaks.worst[0].width, 0.003, 1e-5);
  EXPECT_NEAR(leaks.worst[0].place.y, 2.497, 1e-5);
}

}  // namespace
}  // namespace aktina
