// What every fuzzer does: gives the bytes to a reader, and takes success and aktina::Error for right answers. Anything
// else that a reader does with a file (another exception, a crash, a sanitizer's report, a hang, gigabytes) is a fault.
#pragma once

#include <cstdint>
#include <span>

#include "aktina/base/error.h"

namespace aktina::fuzz {

template <class Read>
void attempt(Read read) {
  try {
    read();
  } catch (const Error&) {
    return;
  }
}

}  // namespace aktina::fuzz

/// A fuzzer is one file that defines this function.
void fuzz(std::span<const uint8_t> bytes);
