#include "aktina/render/validate.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/render/report.h"
#include "aktina/render/validate_cases.h"

namespace aktina {
namespace {

ValidationResult run(const ValidationCase& test) {
  Stopwatch watch;
  ValidationResult result{&test, NAN, 0, {}};
  try {
    result.value = test.compute();
  } catch (const Error& error) {
    result.failure = error.what();
  }
  result.seconds = watch.lap();
  return result;
}

std::string known_groups() {
  std::string known;
  for (const ValidationCase& test : validation_cases())
    if (!known.ends_with(test.group)) known += (known.empty() ? "" : ", ") + test.group;
  return known;
}

}  // namespace

const std::vector<ValidationCase>& validation_cases() {
  static const std::vector<ValidationCase> cases = [] {
    std::vector<ValidationCase> all;
    add_photometry_cases(all);
    add_form_factor_cases(all);
    add_furnace_cases(all);
    add_enclosure_cases(all);
    return all;
  }();
  return cases;
}

std::vector<ValidationResult> validate(std::string_view group, Progress& progress) {
  std::vector<const ValidationCase*> chosen;
  for (const ValidationCase& test : validation_cases())
    if (group.empty() || test.group == group) chosen.push_back(&test);
  if (chosen.empty())
    throw Error(Code::usage, std::string(group), "no such group of checks", "there are: " + known_groups());

  progress.begin("validating", "checks", chosen.size());
  std::vector<ValidationResult> results;
  for (const ValidationCase* test : chosen) {
    progress.throw_if_cancelled();
    results.push_back(run(*test));
    progress.advance();
  }
  return results;
}

std::string to_json(std::span<const ValidationResult> results) {
  auto cases = nlohmann::ordered_json::array();
  uint64_t passed = 0;
  for (const ValidationResult& result : results) {
    const ValidationCase& test = *result.test;
    passed += result.passed();
    cases.push_back({{"group", test.group},
                     {"name", test.name},
                     {"unit", test.unit},
                     {"reference", test.reference},
                     {"result", result.value},
                     {"error", result.error()},
                     {"tolerance", test.tolerance},
                     {"passed", result.passed()},
                     {"seconds", result.seconds},
                     {"source", test.source}});
    if (!result.failure.empty()) cases.back()["failure"] = result.failure;
  }
  return nlohmann::ordered_json{{"passed", passed}, {"failed", results.size() - passed}, {"cases", std::move(cases)}}
      .dump();
}

}  // namespace aktina
