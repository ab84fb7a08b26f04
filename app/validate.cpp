// aktina validate: known values, computed by this very program.
#include "aktina/render/validate.h"

#include <fmt/core.h>

#include "aktina/base/error.h"
#include "session.h"

namespace aktina::app {
namespace {

std::string table(const std::vector<ValidationResult>& results) {
  std::string text = fmt::format("{:<66} {:>12} {:>12} {:>10}\n", "check", "reference", "result", "error");
  std::string_view group;
  for (const ValidationResult& result : results) {
    const ValidationCase& test = *result.test;
    if (test.group != group) text += fmt::format("\n{}\n", test.group);
    group = test.group;
    text += fmt::format("  {:<64} {:>12.7g} {:>12.7g} {:>10.2e} {:<6} {}\n", test.name, test.reference, result.value,
                        result.error(), test.unit, result.passed() ? "pass" : "FAIL");
    if (!result.failure.empty()) text += fmt::format("    {}\n", result.failure);
  }
  return text;
}

int run(const Arguments& arguments, Session& session) {
  const std::vector<ValidationResult> results = validate(arguments.text("group"), session.progress());
  size_t failed = 0;
  for (const ValidationResult& result : results) failed += !result.passed();
  const std::string text = table(results) + fmt::format("\n{} passed, {} failed\n", results.size() - failed, failed);
  return session.finish({}, text, to_json(results), failed == 0 ? 0 : info(Code::check_failed).exit_status);
}

constexpr Option kOptions[] = {
    {.name = "group", .help = "only the checks of this group", .kind = Kind::text, .value = "GROUP"},
};
constexpr Example kExamples[] = {
    {"the whole suite", "aktina validate"},
    {"photometry only, for a program to read", "aktina validate --group photometry --json"},
};

}  // namespace

extern constinit const Command validate_command = {
    "validate",
    "compute values that are known in closed form, and compare",
    "Runs the suite that comes with Aktina on the program as it is installed here: for each check it prints the "
    "reference, the result and the error. Exit status 5 if one fails.",
    {},
    kOptions,
    true,
    kExamples,
    run};

}  // namespace aktina::app
