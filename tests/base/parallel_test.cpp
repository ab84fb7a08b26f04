#include "aktina/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "aktina/base/error.h"
#include "aktina/base/progress.h"

namespace aktina {
namespace {

TEST(Parallel, VisitsEachItemOnceForAnyThreadCount) {
  for (const int threads : {1, 2, 5, 0}) {
    set_thread_count(threads);
    std::vector<std::atomic<int>> visits(10007);
    parallel_for(visits.size(), 13, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) ++visits[i];
    });
    for (const auto& v : visits) ASSERT_EQ(v, 1);
  }
}

TEST(Parallel, PassesExceptionsOn) {
  for (const int threads : {1, 2}) {
    set_thread_count(threads);
    EXPECT_THROW(parallel_for(100, 1,
                              [](size_t begin, size_t) {
                                if (begin == 57 || begin == 0) throw std::runtime_error("57");
                              }),
                 std::runtime_error);
  }
  set_thread_count(0);
}

TEST(Parallel, FlushesDenormalsOnlyInside) {
  volatile float tiny = 1e-38f;
  parallel_for(4, 1, [&](size_t, size_t) { EXPECT_EQ(tiny * 0.01f, 0); });
  EXPECT_GT(tiny * 0.01f, 0);
}

TEST(Progress, CountsAndCancels) {
  int calls = 0;
  Progress progress([&](const ProgressState&) { ++calls; }, 0);
  progress.begin("tracing", "tiles", 10);
  for (int i = 0; i < 10; ++i) progress.advance();
  EXPECT_EQ(progress.state().done, 10U);
  EXPECT_GE(calls, 2);
  EXPECT_NO_THROW(progress.throw_if_cancelled());
  progress.cancel();
  EXPECT_THROW(progress.throw_if_cancelled(), Error);
}

}  // namespace
}  // namespace aktina
