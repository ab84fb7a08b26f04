// The shipped suite: what Aktina computes against values known in closed form. Run on the installed program.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "aktina/base/progress.h"

namespace aktina {

/// One number that is known.
struct ValidationCase {
  std::string group;  // "photometry", "formfactor", "furnace"
  std::string name;   // "100 lm Lambertian disc, on axis at 1 m"
  std::string unit;   // "lx", "1"
  double reference;
  double tolerance;    // largest absolute error that passes
  std::string source;  // where the reference comes from
  std::function<double()> compute;
};

struct ValidationResult {
  const ValidationCase* test;
  double value;  // NaN where the computation failed
  double seconds;
  std::string failure;  // the error's text, if it failed
  double error() const { return value - test->reference; }
  bool passed() const { return error() <= test->tolerance && -error() <= test->tolerance; }  // false for NaN
};

/// All cases, grouped.
const std::vector<ValidationCase>& validation_cases();

/// Runs the cases whose group is `group`, or all, in order. @throws Error usage (no such group), cancelled
std::vector<ValidationResult> validate(std::string_view group, Progress& progress);

/// JSON object: {"passed": 12, "failed": 0, "cases": [...]}.
std::string to_json(std::span<const ValidationResult> results);

}  // namespace aktina
