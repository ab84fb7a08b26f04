// Solutions on disk: what is written is read, and what is damaged is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "aktina/base/error.h"
#include "aktina/base/hash.h"
#include "aktina/base/random.h"
#include "aktina/radiosity/solve.h"
#include "radiosity/scenes.h"
#include "test_files.h"

namespace aktina {
namespace {

Solution small_solution() {
  Scene scene = room({1, 1, 1}, Rgb(1));
  scene.lights.push_back({"lamp", PointLight{{0.5f, 0.5f, 0.5f}}, -1});
  return solve_radiosity(scene, {.patch_size = 0.5, .tolerance = 0.1});
}

std::vector<uint8_t> saved(const Solution& solution, const Path& path) {
  save_solution(path, solution);
  return read_file(path);
}

/// Gives bytes that were changed on purpose a checksum that fits.
void seal(std::vector<uint8_t>& bytes) {
  Hash64 hash;
  hash.add(std::as_bytes(std::span(bytes).subspan(16)));
  const uint64_t sum = hash.value();
  std::memcpy(bytes.data() + 8, &sum, 8);
}

TEST(SolutionFile, ComesBackBitForBit) {
  const test::TemporaryFolder folder;
  const Solution before = small_solution();
  const std::vector<uint8_t> bytes = saved(before, folder / "a.aktina");
  const Solution after = load_solution(folder / "a.aktina");
  EXPECT_EQ(before.mesh.patches, after.mesh.patches);
  EXPECT_EQ(before.irradiances, after.irradiances);
  EXPECT_EQ(before.vertex_radiosities, after.vertex_radiosities);
  EXPECT_EQ(before.settings, after.settings);
  EXPECT_EQ(before.steps, after.steps);
  EXPECT_EQ(before.warnings.items().size(), after.warnings.items().size());
  EXPECT_FALSE(after.warnings.empty());
  EXPECT_EQ(saved(after, folder / "b.aktina"), bytes);
}

TEST(SolutionFile, EveryTruncationAndEveryFlippedBitIsRefused) {
  const test::TemporaryFolder folder;
  const std::vector<uint8_t> bytes = saved(small_solution(), folder / "a.aktina");
  for (size_t n = 0; n < bytes.size(); n += 1 + n / 9)
    EXPECT_THROW(decode_solution(std::span(bytes).first(n), "x"), Error);
  std::vector<uint8_t> flipped = bytes;
  for (size_t i = 0; i < bytes.size(); i += 1 + i / 9) {
    flipped[i] ^= 4;
    EXPECT_THROW(decode_solution(flipped, "x"), Error) << i;
    flipped[i] ^= 4;
  }
}

TEST(SolutionFile, WrongCountsAndIndicesUnderAnHonestChecksumAreRefusedOrHarmless) {
  const test::TemporaryFolder folder;
  const std::vector<uint8_t> bytes = saved(small_solution(), folder / "a.aktina");
  std::vector<uint8_t> huge = bytes;
  std::memset(huge.data() + 16, 0xff, 8);
  seal(huge);
  EXPECT_THAT([&] { decode_solution(huge, "x"); }, testing::ThrowsMessage<Error>(testing::HasSubstr("longer than")));
  Pcg32 random(3);
  for (int i = 0; i < 3000; ++i) {
    std::vector<uint8_t> changed = bytes;
    changed[16 + random.next() % (bytes.size() - 16)] = uint8_t(random.next());
    seal(changed);
    try {
      const Solution s = decode_solution(changed, "x");
      for (const auto& patch : s.mesh.patches) EXPECT_LT(patch[3], s.mesh.positions.size());
    } catch (const Error&) {
    }
  }
}

TEST(SolutionFile, OtherFilesAndVersionsAreNamed) {
  const test::TemporaryFolder folder;
  std::vector<uint8_t> bytes = saved(small_solution(), folder / "a.aktina");
  bytes[7] = '9';
  EXPECT_THAT([&] { decode_solution(bytes, "x"); }, testing::ThrowsMessage<Error>(testing::HasSubstr("version")));
  bytes[0] = 'B';
  EXPECT_THAT([&] { decode_solution(bytes, "x"); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("not a solution")));
  EXPECT_THROW(load_solution(folder / "none"), Error);
}

}  // namespace
}  // namespace aktina
