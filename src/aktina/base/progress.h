// Progress and cancellation of long work. The worker counts; whoever watches reads, from any thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace aktina {

/// What a watcher sees.
struct ProgressState {
  std::string stage;   // "tracing", "solving"
  std::string unit;    // "tiles", "patches", "samples"
  uint64_t done = 0;   // of `total`
  uint64_t total = 0;  // 0: not known
  double seconds = 0;  // since the stage began
};

class Progress {
 public:
  using Watcher = std::function<void(const ProgressState&)>;

  Progress() = default;
  /// `watcher` is called at most every `interval` seconds, from whichever thread works, never from two at once.
  explicit Progress(Watcher watcher, double interval = 0.1);

  void begin(std::string stage, std::string unit, uint64_t total);
  void advance(uint64_t count = 1);
  ProgressState state() const;

  /// Asks the work to stop soon. Safe in a signal handler.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  /// @throws Error cancelled
  void throw_if_cancelled() const;

 private:
  double now() const;
  void report(bool always);

  std::atomic<bool> cancelled_{false};
  std::atomic<uint64_t> done_{0}, total_{0};
  std::atomic<double> next_report_{0};
  mutable std::mutex mutex_;
  ProgressState state_;
  double begun_ = 0, interval_ = 0.1;
  Watcher watcher_;
};

}  // namespace aktina
