#include "check_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "aktina/base/error.h"
#include "aktina/render/catalogue.h"

namespace aktina::app {
namespace {

std::string range_of(const Option& option) {
  constexpr double kMost = std::numeric_limits<double>::max();
  if (option.min == -kMost && option.max == kMost) return "";
  if (option.max == kMost) return fmt::format("at least {:g}", option.min);
  if (option.kind == Kind::whole) return fmt::format("accepted {:.0f} .. {:.0f}", option.min, option.max);
  return fmt::format("accepted {:g} .. {:g}", option.min, option.max);
}

void check_number(const Option& option, const std::string& name, const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  const bool whole = option.kind == Kind::whole;
  const bool only_digits = text.find_first_of(".eEn") == std::string::npos;
  if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value) || (whole && !only_digits))
    throw Error(Code::usage, name, fmt::format("'{}' is not a {}number", text, whole ? "whole " : ""),
                range_of(option));
  if (value < option.min || value > option.max)
    throw Error(Code::bad_param, name, fmt::format("got {}", text), range_of(option));
}

void check_choice(const Option& option, const std::string& name, const std::string& text) {
  if (std::find(option.choices.begin(), option.choices.end(), text) != option.choices.end()) return;
  throw Error(Code::usage, name, fmt::format("'{}' is not one of its values", text),
              fmt::format("there are: {}", fmt::join(option.choices.begin(), option.choices.end(), ", ")));
}

void check_parameters(const MethodInfo& method, const MethodChoice& choice) {
  ParamSet params(method);
  for (const auto& [id, value] : choice.values) params.set(id, value);
}

/// One of the option's own words; it may be a method of another family.
void check_word(const std::string& name, const MethodChoice& choice) {
  for (const Family& family : families())
    for (const MethodInfo* method : family.methods)
      if (method->id == choice.id) return check_parameters(*method, choice);
  if (!choice.values.empty()) throw Error(Code::usage, name, fmt::format("{} takes no parameters", choice.id));
}

/// The method must be in the catalogue and its parameters within their ranges, or one of the option's own words.
void check_method(const Option& option, const std::string& name, const std::string& text) {
  const MethodChoice choice = parse_method(text);
  if (std::find(option.choices.begin(), option.choices.end(), choice.id) != option.choices.end())
    return check_word(name, choice);
  std::vector<std::string_view> known(option.choices.begin(), option.choices.end());
  const MethodInfo* chosen = nullptr;
  for (const MethodInfo* method : find_family(option.family).methods) {
    if (method->id == choice.id) chosen = method;
    known.push_back(method->id);
  }
  if (!chosen) {
    const std::string_view meant = nearest(choice.id, known);
    throw Error(
        Code::no_such_method, name, fmt::format("there is no {} method '{}'", option.family, choice.id),
        meant.empty() ? fmt::format("there are: {}", fmt::join(known, ", ")) : fmt::format("did you mean {}?", meant));
  }
  check_parameters(*chosen, choice);
}

}  // namespace

void check_value(const Option& option, const std::string& name, const std::string& text) {
  if (text.empty()) throw Error(Code::usage, name, "is empty");
  // A value that begins with two dashes is a forgotten value, not a file called --json.
  if (text.starts_with("--") && text.size() > 2)
    throw Error(Code::usage, name, fmt::format("needs a value, but {} follows", text));
  switch (option.kind) {
    case Kind::number:
    case Kind::whole:
      return check_number(option, name, text);
    case Kind::choice:
      return check_choice(option, name, text);
    case Kind::method:
      return check_method(option, name, text);
    case Kind::flag:
    case Kind::text:
    case Kind::file:
      return;
  }
}

}  // namespace aktina::app
