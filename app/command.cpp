#include "command.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "aktina/base/file.h"

namespace aktina::app {
namespace {

constexpr std::string_view kProgressKinds[] = {"bar", "json", "none"};

constexpr Option kLongWork[] = {
    {.name = "threads",
     .help = "threads to use, 0 for all of the machine; the result is the same",
     .kind = Kind::whole,
     .value = "N",
     .fallback = "0",
     .min = 0,
     .max = 1024,
     .affects_result = false},
    {.name = "progress",
     .help = "show progress on standard error even where that is no terminal; json: one object a line",
     .kind = Kind::choice,
     .value = "HOW",
     .choices = kProgressKinds,
     .implied = "bar",
     .affects_result = false},
};
constexpr Option kCommon[] = {
    {.name = "json", .help = "print one machine-readable report on standard output", .affects_result = false},
    {.name = "quiet", .help = "print errors only", .letter = 'q', .affects_result = false},
};

}  // namespace

std::vector<const Option*> all_options(const Command& command) {
  std::vector<const Option*> options;
  for (const Option& option : command.options) options.push_back(&option);
  if (command.long_work)
    for (const Option& option : kLongWork) options.push_back(&option);
  for (const Option& option : kCommon) options.push_back(&option);
  return options;
}

const Arguments::Value& Arguments::find(std::string_view name) const {
  for (const Value& value : values)
    if (value.option->name == name) return value;
  throw std::logic_error(fmt::format("the command has no option '{}'", name));
}

const std::string& Arguments::text(std::string_view name) const {
  static const std::string nothing;
  const std::vector<std::string>& texts = all(name);
  return texts.empty() ? nothing : texts.back();
}

double Arguments::number(std::string_view name) const { return std::stod(text(name)); }
int64_t Arguments::whole(std::string_view name) const { return std::stoll(text(name)); }

std::string settings_line(const Command& command, const Arguments& arguments) {
  std::string line(command.name);
  for (size_t i = 0; i < arguments.values.size(); ++i) {
    const auto& [option, texts, given] = arguments.values[i];
    if (!given || !option->affects_result) continue;
    if (i >= command.inputs.size()) line += fmt::format(" --{}", option->name);
    if (option->kind == Kind::flag) continue;
    for (const std::string& text : texts)
      line += " " + (option->kind == Kind::file ? display(Path(text).filename()) : text);
  }
  return line;
}

namespace {

/// Levenshtein's distance.
size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t substituted = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> known) {
  std::string_view best;
  size_t least = std::max<size_t>(2, word.size() / 3) + 1;
  for (const std::string_view candidate : known) {
    const size_t d = distance(word, candidate);
    if (d < least) least = d, best = candidate;
  }
  return best;
}

}  // namespace aktina::app
