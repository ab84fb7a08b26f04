#include "aktina/illumination/ambient.h"

#include <gtest/gtest.h>

#include "aktina/illumination/illuminate.h"
#include "illumination/model_checks.h"

namespace aktina {
namespace {

TEST(Ambient, IsKaIaWhateverTheLampsDo) {
  const Surface s{.ka = {0.1f, 0.2f, 0.3f}};
  const Light lamps[] = {PointLight{{0, 0, 1}, Intensity(Rgb(100))}};
  const Lit lit = illuminate(Ambient{}, s, lamps, Rgb(2), {0, 0, 0}, {0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(lit.total(), Rgb(0.2f, 0.4f, 0.6f));
}

}  // namespace
}  // namespace aktina
