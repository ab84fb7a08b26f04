#include "aktina/base/progress.h"

#include <chrono>

#include "aktina/base/error.h"

namespace aktina {

Progress::Progress(Watcher watcher, double interval) : interval_(interval), watcher_(std::move(watcher)) {}

double Progress::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void Progress::begin(std::string stage, std::string unit, uint64_t total) {
  {
    const std::lock_guard lock(mutex_);
    state_ = {std::move(stage), std::move(unit), 0, total, 0};
    begun_ = now();
  }
  done_ = 0;
  total_ = total;
  report(true);
}

void Progress::advance(uint64_t count) {
  const uint64_t done = done_.fetch_add(count, std::memory_order_relaxed) + count;
  if (watcher_) report(done == total_);
}

ProgressState Progress::state() const {
  const std::lock_guard lock(mutex_);
  ProgressState state = state_;
  state.done = done_;
  state.seconds = now() - begun_;
  return state;
}

void Progress::report(bool always) {
  if (!watcher_) return;
  const double time = now();
  double due = next_report_.load(std::memory_order_relaxed);
  if (!always && time < due) return;
  if (!next_report_.compare_exchange_strong(due, time + interval_) && !always) return;
  const std::lock_guard lock(mutex_);
  state_.done = done_;
  state_.seconds = time - begun_;
  watcher_(state_);
}

void Progress::throw_if_cancelled() const {
  if (cancelled()) throw Error(Code::cancelled, "", "stopped on request");
}

}  // namespace aktina
