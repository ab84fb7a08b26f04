// What a job says about itself, beside its result: the same numbers for the program, the Python module and the studio.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/warnings.h"

namespace aktina {

struct Report {
  struct Timing {
    std::string stage;  // "load", "build", "trace"
    double seconds;     // wall clock
  };
  struct Count {
    std::string name, unit;  // "paths", "rays/s"; unit "1" for a plain number
    double value;
  };
  std::string settings;  // the command that repeats this result, without paths, threads and other things of no effect
  uint64_t seed = 0;
  std::string scene_file;  // name without folder
  std::string scene_hash;  // of everything that affects the result
  int threads = 0;
  bool complete = true;  // false: stopped before its end; the result is the best so far
  std::vector<Timing> timings;
  std::vector<Count> counts;
  Warnings warnings;

  void time(std::string stage, double seconds) { timings.push_back({std::move(stage), seconds}); }
  void count(std::string name, double value, std::string unit = "1") {
    counts.push_back({std::move(name), std::move(unit), value});
  }
};

/// JSON text, one object; docs/command_line.md describes it.
std::string to_json(const Report& report);

/// What every output file records of the job that made it: program, version, settings, seed, scene and its hash. No
/// timings, so that the same settings give the same bytes.
std::vector<std::pair<std::string, std::string>> provenance(const Report& report);

/// Seconds since it was made or last asked.
class Stopwatch {
 public:
  Stopwatch();
  double lap();

 private:
  double last_;
};

}  // namespace aktina
