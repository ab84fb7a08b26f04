// Least times of several methods, measured in turn: what disturbs the machine disturbs all of them alike.
#pragma once

#include <span>

#include "aktina/base/parallel.h"
#include "aktina/render/study/variant.h"

namespace aktina {

/// Frames of each variant, one after another, `rounds` times over and once before; on `threads` threads, which stay
/// set. Slow methods (more than a second a frame) get fewer rounds.
/// @return  the least of each half and of the whole, for each variant; unknown where a variant failed
std::vector<FrameTime> race(std::span<const Variant* const> variants, const Camera& camera, int width, int height,
                            int rounds, int threads, Progress& progress);

/// Gives the number of threads back that was set.
class ThreadsKept {
 public:
  ThreadsKept() : count_(thread_count()) {}
  ~ThreadsKept() { set_thread_count(count_); }
  ThreadsKept(const ThreadsKept&) = delete;
  ThreadsKept& operator=(const ThreadsKept&) = delete;
  int count() const { return count_; }

 private:
  int count_;
};

}  // namespace aktina
