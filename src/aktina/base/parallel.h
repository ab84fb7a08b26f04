// Parallel loops over all cores (oneTBB behind parallel.cpp). Results must not depend on how the range is cut.
#pragma once

#include <cstddef>

#include "aktina/base/function_ref.h"

namespace aktina {

/// Threads that parallel loops use from now on; 0: as many as the machine has.
void set_thread_count(int threads);
int thread_count();

/// Calls body(begin, end) on disjoint pieces of [0, n) of about `grain` items; denormals are flushed to zero
/// inside. An exception in a body ends the loop and comes out here.
void parallel_for(size_t n, size_t grain, FunctionRef<void(size_t begin, size_t end)> body);

/// Runs work that a library spreads over threads of its own accord (Embree's builds), within the same limit.
void within_thread_limit(FunctionRef<void()> work);

/// Flushes denormal numbers to zero in this thread while it lives (they make pow several times slower).
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

}  // namespace aktina
