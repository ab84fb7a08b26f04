#include "aktina/render/study/instructions.h"

#if defined(__linux__)
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace aktina {

#if defined(__linux__)

InstructionCounter::InstructionCounter() {
  perf_event_attr attributes{};
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.size = sizeof attributes;
  attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
  attributes.exclude_kernel = 1, attributes.exclude_hv = 1;
  file_ = int(::syscall(SYS_perf_event_open, &attributes, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
}

InstructionCounter::~InstructionCounter() {
  if (file_ >= 0) ::close(file_);
}

std::optional<uint64_t> InstructionCounter::count() const {
  uint64_t value = 0;
  if (file_ < 0 || ::read(file_, &value, sizeof value) != ssize_t(sizeof value) || value == 0) return {};
  return value;
}

#else

InstructionCounter::InstructionCounter() = default;
InstructionCounter::~InstructionCounter() = default;
std::optional<uint64_t> InstructionCounter::count() const { return {}; }

#endif

}  // namespace aktina
