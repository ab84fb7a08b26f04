#include "aktina/render/study/peak_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "aktina/render/study/study.h"

namespace aktina {
namespace {

/// A line of /proc/self/status, in bytes.
double status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;)
    if (word == name + ":") {
      double kilobytes = kNotMeasured;
      file >> kilobytes;
      return kilobytes * 1024;
    }
  return kNotMeasured;
}

}  // namespace

PeakMemory::PeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";  // the peak so far is forgotten
  before_ = status("VmRSS");
}

double PeakMemory::bytes() const { return std::max(status("VmHWM") - before_, 0.0); }

}  // namespace aktina
