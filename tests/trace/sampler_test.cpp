#include "aktina/trace/sampler.h"

#include <gtest/gtest.h>

namespace aktina {
namespace {

TEST(Sampler, SixteenAtATimeAreTheSameNumbers) {
  for (uint32_t round = 0; round < 100; ++round) {
    SequencePacket sequences;
    for (int lane = 0; lane < kPacket; ++lane) {
      const uint32_t k = round * 16 + uint32_t(lane);
      sequences.set(lane, {hash32(k), k * k}, k % 60);
    }
    PairPacket pairs;
    sample_pairs(sequences, 3, pairs);
    for (int lane = 0; lane < kPacket; ++lane) {
      const uint32_t k = round * 16 + uint32_t(lane);
      EXPECT_EQ(pairs.at(lane), (SampleSequence{hash32(k), k * k}.pair(k % 60 + 3)));
    }
  }
}

TEST(Sampler, DimensionsAreApart) {
  // The mean of the product of two independent uniform numbers is 1/4.
  double product = 0;
  for (uint32_t i = 0; i < 4096; ++i) {
    const SampleSequence s{7, i};
    product += double(s.pair(0).x) * double(s.pair(1).x);
  }
  EXPECT_NEAR(product / 4096, 0.25, 0.01);
}

}  // namespace
}  // namespace aktina
