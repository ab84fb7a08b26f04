// Instructions that this thread executes, where the machine counts them.
#pragma once

#include <cstdint>
#include <optional>

namespace aktina {

/// Counts while it lives; user code of the calling thread only.
class InstructionCounter {
 public:
  InstructionCounter();
  ~InstructionCounter();
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;

  /// Since it was made; nothing on machines (virtual ones, often) or systems that do not count.
  std::optional<uint64_t> count() const;

 private:
  int file_ = -1;
};

}  // namespace aktina
