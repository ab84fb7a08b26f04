// Work that shows no progress of its own, but ends where that of the study is cancelled.
#pragma once

#include <optional>

#include "aktina/base/progress.h"

namespace aktina {

/// Calls `work` with a progress of its own that is cancelled where `outer` is. @throws Error cancelled
template <class Work>
auto within(Progress& outer, const Work& work) {
  std::optional<Progress> inner;
  inner.emplace(
      [&](const ProgressState&) {
        if (outer.cancelled()) inner->cancel();
      },
      0.05);
  auto result = work(*inner);
  outer.throw_if_cancelled();
  return result;
}

}  // namespace aktina
