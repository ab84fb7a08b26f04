// --help, made of the command tables.
#include <fmt/core.h>

#include "aktina/base/version.h"
#include "command.h"

namespace aktina::app {
namespace {

constexpr size_t kWidth = 100, kTermWidth = 28;

/// Words of `text` in lines that begin at column `indent`; the first one stands at `column` already.
std::string wrapped(std::string_view text, size_t indent, size_t column) {
  std::string out;
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    if (column > indent && column + 1 + word.size() > kWidth) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      out += " ";
      ++column;
    }
    out += word;
    column += word.size();
    const bool line_ends = end < text.size() && text[end] == '\n';
    if (line_ends) out += "\n" + std::string(indent, ' '), column = indent;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string entry(const std::string& term, const std::string& text) {
  std::string line = "  " + term;
  if (line.size() + 2 > kTermWidth)
    line += "\n" + std::string(kTermWidth, ' ');
  else
    line.resize(kTermWidth, ' ');
  return line + wrapped(text, kTermWidth, kTermWidth) + "\n";
}

}  // namespace

std::string option_term(const Option& option) {
  std::string term =
      option.letter ? fmt::format("-{}, --{}", option.letter, option.name) : fmt::format("    --{}", option.name);
  if (!option.implied.empty()) return fmt::format("{}[={}]", term, option.value);
  return option.kind == Kind::flag ? term : fmt::format("{} {}", term, option.value);
}

std::string option_text(const Option& option) {
  std::string text(option.help);
  if (!option.choices.empty()) {
    std::string choices;
    for (const std::string_view choice : option.choices) choices += (choices.empty() ? "" : ", ") + std::string(choice);
    text += fmt::format(": {}", choices);
  }
  if (option.kind == Kind::method) text += fmt::format(" (aktina methods --family {} lists them)", option.family);
  if (!option.fallback.empty()) text += fmt::format(" (default {})", option.fallback);
  return text;
}

std::string usage_line(const Command& command) {
  std::string line = fmt::format("aktina {} [options]", command.name);
  for (const Option& input : command.inputs) {
    const std::string shown = fmt::format("{}{}", input.value, input.several ? "..." : "");
    line += input.required ? " " + shown : " [" + shown + "]";
  }
  for (const Option* option : all_options(command))
    if (option->required) line += fmt::format(" -{} {}", option->letter, option->value);
  return line;
}

std::string help_text(const Command& command) {
  std::string text = fmt::format("aktina {}: {}\n\nUsage: {}\n\n{}\n", command.name, command.summary,
                                 usage_line(command), wrapped(command.description, 0, 0));
  if (!command.inputs.empty()) text += "\nInput:\n";
  for (const Option& input : command.inputs) text += entry(std::string(input.value), option_text(input));
  text += "\nOptions:\n";
  for (const Option* option : all_options(command)) text += entry(option_term(*option), option_text(*option));
  text += entry("-h, --help", "print this");
  text += "\nExamples:\n";
  for (const Example& example : command.examples) text += fmt::format("  # {}\n  {}\n", example.what, example.line);
  return text;
}

std::string help_text() {
  std::string text = fmt::format(
      "Aktina {}: computes how light falls on surfaces, and draws what the eye would see.\n\n"
      "Usage: aktina COMMAND [options] INPUT... -o OUTPUT\n\nCommands:\n",
      version());
  for (const Command* command : commands()) text += entry(std::string(command->name), std::string(command->summary));
  text += "\nOptions:\n";
  text += entry("    --version", "print the version");
  text += entry("    --completion SHELL", "print the completion script of a shell: bash, zsh, fish");
  text += entry("-h, --help", "print this; aktina COMMAND --help tells more");
  text += "\nExamples:\n";
  for (const Command* command : commands())
    if (!command->examples.empty()) text += fmt::format("  {}\n", command->examples.front().line);
  text +=
      "\nExit status: 0 done, 2 wrong usage, 3 bad input or output file, 4 over a limit of memory or size,\n"
      "5 a check failed, 130 stopped, 1 anything else.\n";
  return text;
}

}  // namespace aktina::app
