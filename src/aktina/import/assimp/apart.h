// Work on hostile bytes by code that may crash, hang or eat memory, in a process of its own.
#pragma once

#include <functional>
#include <string>

#include "aktina/import/assimp/document.h"

namespace aktina::assimp {

struct Limits {
  uint64_t most_bytes = 0;  // of memory beyond what is there already
  unsigned seconds = 60;    // of computing time
};

/// Forks; `work` runs in the child, with limits, without output, and writes to its sink; `take` reads here what comes.
/// What `work` throws is thrown here as an Error; so is its crash, and a limit that it meets.
/// @throws Error
void run_apart(const Limits& limits, const std::string& where, const std::function<void(const Sink&)>& work,
               const std::function<void(const Source&)>& take);

}  // namespace aktina::assimp
