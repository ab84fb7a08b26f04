// What the benchmark programs share: times of contenders taken in turn, and rows of build/bench.json.
//
// A row is a ratio measured in one run wherever that can be, for absolute times differ from machine to machine. Each
// program prints its rows as JSON lines on stdout; scripts/bench.sh runs all of them, and joins and prints the rows.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "aktina/base/function_ref.h"

namespace aktina::bench {

/// What a value must reach, or stay below, to be good enough.
struct Goal {
  double value;
  bool at_least = true;
};

/// Prints a row. @param id  dotted, "raster.phong.llvmpipe"; @param unit  "x" for ratios
inline void report(std::string_view id, std::string_view what, double value, std::string_view unit,
                   std::optional<Goal> goal = {}) {
  const bool met = !goal || (goal->at_least ? value >= goal->value : value <= goal->value);
  fmt::print(R"({{"id": "{}", "what": "{}", "value": {:.4g}, "unit": "{}", "goal": {}, "met": {}}})"
             "\n",
             id, what, value, unit, goal ? fmt::format("{:g}", goal->value) : "null", met);
  std::fflush(stdout);
}

inline double seconds(FunctionRef<void()> work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Least seconds of each contender, over `rounds` rounds in which each has its turn: what disturbs the machine then
/// disturbs all of them. One round before warms up.
inline std::vector<double> race(int rounds, std::initializer_list<FunctionRef<void()>> contenders) {
  std::vector<double> least(contenders.size(), 1e30);
  for (int round = -1; round < rounds; ++round) {
    size_t i = 0;
    for (const auto& contender : contenders) {
      const double t = seconds(contender);
      if (round >= 0) least[i] = std::min(least[i], t);
      ++i;
    }
  }
  return least;
}

}  // namespace aktina::bench
