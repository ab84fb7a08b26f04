// Long work: in a thread of its own without the interpreter's lock, while the calling thread watches for Ctrl-C and
// reports progress. Python runs signal handlers in its main thread only, so the watching cannot be left to workers.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <utility>

#include "aktina/base/progress.h"

namespace aktina::python {

/// Runs `work`, calls `report(stage, unit, done, total, seconds)` (None: nobody) ten times a second from the calling
/// thread, and comes back when the work has ended. Ctrl-C, or an exception in `report`, asks the work to stop, waits
/// until it has, and comes out as the exception it is.
void run_interruptible(const pybind11::object& report, const std::function<void(Progress&)>& work);

/// The same for work that gives something back.
template <class Work>
auto run(const pybind11::object& report, Work&& work) {
  std::optional<decltype(work(std::declval<Progress&>()))> result;
  run_interruptible(report, [&](Progress& progress) { result.emplace(work(progress)); });
  return std::move(*result);
}

}  // namespace aktina::python
