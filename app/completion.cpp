// Completion scripts for bash, zsh and fish, made of the command tables and the catalogue.
#include <fmt/format.h>

#include "aktina/base/error.h"
#include "aktina/render/catalogue.h"
#include "command.h"

namespace aktina::app {
namespace {

std::vector<std::string> values(const Option& option) {
  std::vector<std::string> list(option.choices.begin(), option.choices.end());
  if (option.kind == Kind::method)
    for (const MethodInfo* method : find_family(option.family).methods) list.emplace_back(method->id);
  return list;
}

std::vector<std::string> dashed(const Command& command) {
  std::vector<std::string> names = {"--help"};
  for (const Option* option : all_options(command)) names.push_back(fmt::format("--{}", option->name));
  return names;
}

std::string command_names() {
  std::string names;
  for (const Command* command : commands()) names += (names.empty() ? "" : " ") + std::string(command->name);
  return names;
}

/// case branches "COMMAND,--option) words ;;" that bash and zsh both read.
std::string value_cases() {
  std::string text;
  for (const Command* command : commands())
    for (const Option* option : all_options(*command)) {
      if (const std::vector<std::string> words = values(*option); !words.empty())
        text += fmt::format("    {},--{}) words=\"{}\" ;;\n", command->name, option->name, fmt::join(words, " "));
    }
  return text;
}

std::string option_cases() {
  std::string text;
  for (const Command* command : commands())
    text += fmt::format("    {}) words=\"{}\" ;;\n", command->name, fmt::join(dashed(*command), " "));
  return text;
}

std::string bash() {
  return fmt::format(
      "# bash completion of aktina\n"
      "_aktina() {{\n"
      "  local current=\"${{COMP_WORDS[COMP_CWORD]}}\" previous=\"${{COMP_WORDS[COMP_CWORD-1]}}\" words=\"\"\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W \"{} --help --version --completion\" -- \"$current\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${{COMP_WORDS[1]}},$previous\" in\n"
      "{}"
      "  esac\n"
      "  if [ -z \"$words\" ] && [[ \"$current\" == -* ]]; then\n"
      "    case \"${{COMP_WORDS[1]}}\" in\n"
      "{}"
      "    esac\n"
      "  fi\n"
      "  if [ -n \"$words\" ]; then COMPREPLY=($(compgen -W \"$words\" -- \"$current\")); fi\n"
      "}}\n"
      "complete -o default -F _aktina aktina\n",
      command_names(), value_cases(), option_cases());
}

std::string zsh() {
  return fmt::format(
      "#compdef aktina\n"
      "_aktina() {{\n"
      "  local words_=\"\" previous=\"$words[CURRENT-1]\" command=\"$words[2]\"\n"
      "  if (( CURRENT == 2 )); then\n"
      "    compadd {} --help --version --completion\n"
      "    return\n"
      "  fi\n"
      "  local -a list\n"
      "  () {{\n"
      "    local words=\"\"\n"
      "    case \"$command,$previous\" in\n"
      "{}"
      "    esac\n"
      "    if [[ -z \"$words\" && \"$PREFIX\" == -* ]]; then\n"
      "      case \"$command\" in\n"
      "{}"
      "      esac\n"
      "    fi\n"
      "    list=(${{=words}})\n"
      "  }}\n"
      "  if (( $#list )); then compadd -- $list; else _files; fi\n"
      "}}\n"
      "_aktina \"$@\"\n",
      command_names(), value_cases(), option_cases());
}

std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("\\'") : std::string(1, c);
  return out + "'";
}

std::string fish() {
  std::string text = "# fish completion of aktina\n";
  for (const Command* command : commands())
    text += fmt::format("complete -c aktina -n __fish_use_subcommand -a {} -d {}\n", command->name,
                        quoted(command->summary));
  for (const Command* command : commands())
    for (const Option* option : all_options(*command)) {
      text += fmt::format("complete -c aktina -n '__fish_seen_subcommand_from {}' -l {}", command->name, option->name);
      if (option->letter) text += fmt::format(" -s {}", option->letter);
      const std::vector<std::string> words = values(*option);
      if (!words.empty())
        text += fmt::format(" -x -a '{}'", fmt::join(words, " "));
      else if (option->kind != Kind::flag)
        text += " -r";
      text += fmt::format(" -d {}\n", quoted(option->help));
    }
  return text;
}

}  // namespace

std::string completion_script(std::string_view shell) {
  if (shell == "bash") return bash();
  if (shell == "zsh") return zsh();
  if (shell == "fish") return fish();
  throw Error(Code::usage, std::string(shell), "no completion for this shell", "there are: bash, zsh, fish");
}

}  // namespace aktina::app
