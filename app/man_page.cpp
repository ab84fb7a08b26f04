// aktina(1), made of the command tables.
#include <fmt/core.h>

#include "aktina/base/version.h"
#include "help.h"

namespace aktina::app {
namespace {

/// Text as troff wants it.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
      out += fmt::format("\\&{}", c);
    else
      out += c;
  }
  return out;
}

std::string entry(std::string_view term, std::string_view text) {
  return fmt::format(".TP\n.B {}\n{}\n", escaped(term.substr(term.find_first_not_of(' '))), escaped(text));
}

std::string section(const Command& command) {
  std::string text = fmt::format(".SS {}\n{}.\n.PP\n.B {}\n.PP\n{}\n", escaped(command.name), escaped(command.summary),
                                 escaped(usage_line(command)), escaped(command.description));
  for (const Option& input : command.inputs) text += entry(input.value, option_text(input));
  for (const Option* option : all_options(command)) text += entry(option_term(*option), option_text(*option));
  text += ".PP\nExamples:\n";
  for (const Example& example : command.examples)
    text += fmt::format(".PP\n{}:\n.PP\n.RS\n.nf\n{}\n.fi\n.RE\n", escaped(example.what), escaped(example.line));
  return text;
}

}  // namespace

std::string man_page() {
  std::string text = fmt::format(
      ".TH AKTINA 1 \"\" \"aktina {}\"\n.SH NAME\n"
      "aktina \\- computes how light falls on surfaces, and draws what the eye would see\n"
      ".SH SYNOPSIS\n.B aktina\nCOMMAND [options] INPUT... \\-o OUTPUT\n.SH COMMANDS\n",
      version());
  for (const Command* command : commands()) text += section(*command);
  text +=
      ".SH \"EXIT STATUS\"\n0 done; 2 wrong usage; 3 bad input or output file; 4 over a limit of memory or size; "
      "5 a check failed; 130 stopped by Ctrl\\-C or SIGTERM; 1 anything else.\n"
      ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nNo colours on the terminal where it is set.\n";
  return text;
}

}  // namespace aktina::app
