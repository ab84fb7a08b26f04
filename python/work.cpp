#include "work.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "aktina/base/error.h"

namespace aktina::python {
namespace {

namespace py = pybind11;

constexpr auto kGlance = std::chrono::milliseconds(50);  // how often the calling thread looks up

/// A thread that runs `work` once.
class Worker {
 public:
  Worker(const std::function<void(Progress&)>& work, Progress& progress)
      : thread_([this, &work, &progress] {
          try {
            work(progress);
          } catch (...) {
            error_ = std::current_exception();
          }
          const std::lock_guard lock(mutex_);
          ended_ = true;
          end_.notify_one();
        }) {}
  ~Worker() { thread_.join(); }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  bool ended_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return end_.wait_for(lock, time, [this] { return ended_; });
  }
  void wait() {
    std::unique_lock lock(mutex_);
    end_.wait(lock, [this] { return ended_; });
  }
  std::exception_ptr error() const { return error_; }

 private:
  std::mutex mutex_;
  std::condition_variable end_;
  bool ended_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // last: starts when the rest is there
};

void tell(const py::object& report, const ProgressState& state) {
  if (!report.is_none()) report(state.stage, state.unit, state.done, state.total, state.seconds);
}

}  // namespace

void run_interruptible(const py::object& report, const std::function<void(Progress&)>& work) {
  Progress progress;
  std::exception_ptr from_python;
  const py::gil_scoped_release without_lock;
  Worker worker(work, progress);
  for (int glance = 1; !worker.ended_within(kGlance); ++glance) {
    const py::gil_scoped_acquire with_lock;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (glance % 2 == 0) tell(report, progress.state());
    } catch (...) {
      from_python = std::current_exception();
      break;
    }
  }
  if (from_python) progress.cancel();
  worker.wait();
  if (from_python) std::rethrow_exception(from_python);
  if (worker.error()) std::rethrow_exception(worker.error());
  const py::gil_scoped_acquire with_lock;
  tell(report, progress.state());
}

}  // namespace aktina::python
