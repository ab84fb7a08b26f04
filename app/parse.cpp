// The command line, by CLI11: the only file that includes it (8 s of compile time).
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "aktina/base/error.h"
#include "check_value.h"
#include "command.h"

namespace aktina::app {
namespace {

std::string help_hint(const Command& command) { return fmt::format("see aktina {} --help", command.name); }

/// --progress alone means --progress=bar: CLI11 would take the next word for its value.
std::vector<std::string> with_implied_values(const std::vector<const Option*>& options,
                                             std::span<const char* const> words) {
  std::vector<std::string> result;
  for (const std::string word : words) {
    result.push_back(word);
    for (const Option* option : options)
      if (!option->implied.empty() && word == fmt::format("--{}", option->name))
        result.back() += fmt::format("={}", option->implied);
  }
  return result;
}

CLI::Option* declare(CLI::App& app, Arguments::Value& value, bool input) {
  const Option& option = *value.option;
  const std::string letter = option.letter ? fmt::format("-{},", option.letter) : "";
  const std::string name = input ? std::string(option.name) : fmt::format("{}--{}", letter, option.name);
  if (option.kind == Kind::flag) return app.add_flag(name);
  CLI::Option* const declared = app.add_option(name, value.texts);
  if (option.several) return declared->allow_extra_args(input);
  declared->expected(1)->allow_extra_args(false);  // an input leaves the next word to the next input
  return input ? declared : declared->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

[[noreturn]] void refuse_unknown(const Command& command, const Arguments& arguments, const std::string& word) {
  if (word.size() < 2 || word[0] != '-') throw Error(Code::usage, word, "one argument too many", help_hint(command));
  std::vector<std::string_view> names = {"help"};
  for (size_t i = command.inputs.size(); i < arguments.values.size(); ++i)
    names.push_back(arguments.values[i].option->name);
  const std::string_view bare = std::string_view(word).substr(word.starts_with("--") ? 2 : 1);
  const std::string_view name = nearest(bare.substr(0, bare.find('=')), names);
  throw Error(Code::usage, word, "no such option",
              name.empty() ? help_hint(command) : fmt::format("did you mean --{}?", name));
}

/// Checks what was given, fills in what was not.
void complete(Arguments::Value& value, const std::string& name, const Command& command) {
  const Option& option = *value.option;
  for (const std::string& text : value.texts) check_value(option, name, text);
  if (!value.given && option.required) throw Error(Code::usage, name, "is missing", help_hint(command));
  if (!value.given && !option.fallback.empty()) value.texts = {std::string(option.fallback)};
}

}  // namespace

Arguments parse(const Command& command, std::span<const char* const> words) {
  const std::vector<const Option*> options = all_options(command);
  Arguments arguments;
  for (const Option& input : command.inputs) arguments.values.push_back({&input, {}});
  for (const Option* option : options) arguments.values.push_back({option, {}});

  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<const CLI::Option*> declared;
  for (Arguments::Value& value : arguments.values)
    declared.push_back(declare(app, value, declared.size() < command.inputs.size()));

  std::vector<std::string> given = with_implied_values(options, words);
  std::reverse(given.begin(), given.end());  // as CLI11 wants it
  try {
    app.parse(given);
  } catch (const CLI::ParseError& error) {
    throw Error(Code::usage, "", error.what(), help_hint(command));
  }
  for (const std::string& word : app.remaining())  // "--": what follows are names, whatever they begin with
    if (word != "--") refuse_unknown(command, arguments, word);

  for (size_t i = 0; i < arguments.values.size(); ++i) {
    Arguments::Value& value = arguments.values[i];
    value.given = declared[i]->count() > 0;
    const bool input = i < command.inputs.size();
    complete(value, input ? std::string(value.option->value) : fmt::format("--{}", value.option->name), command);
  }
  return arguments;
}

}  // namespace aktina::app
