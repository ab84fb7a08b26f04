// The program: picks the subcommand, and turns every error into one line and an exit status.
#include <fmt/core.h>

#include <new>

#include "aktina/base/error.h"
#include "aktina/base/version.h"
#include "command.h"
#include "session.h"
#include "terminal.h"

namespace aktina::app {
namespace {

bool is_help(std::string_view word) { return word == "--help" || word == "-h"; }

const Command& find_command(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Command* command : commands()) {
    if (command->name == name) return *command;
    names.push_back(command->name);
  }
  const std::string_view meant = nearest(name, names);
  throw Error(Code::usage, std::string(name), "no such command",
              meant.empty() ? "aktina --help lists them" : fmt::format("did you mean aktina {}?", meant));
}

int run(std::span<const char* const> words) {
  if (words.empty()) {
    print_error_line(help_text());
    return info(Code::usage).exit_status;
  }
  const std::string_view first = words[0];
  const std::string_view second = words.size() > 1 ? words[1] : "";
  if (first == "--version") return print(fmt::format("aktina {}\n", version())), 0;
  if (first == "--completion") return print(completion_script(second)), 0;
  if (first == "--man") return print(man_page()), 0;
  if (is_help(first) || (first == "help" && second.empty())) return print(help_text()), 0;
  if (first == "help") return print(help_text(find_command(second))), 0;

  const Command& command = find_command(first);
  for (const std::string_view word : words.subspan(1)) {
    if (word == "--") break;
    if (is_help(word)) return print(help_text(command)), 0;
  }
  const Arguments arguments = parse(command, words.subspan(1));
  static Session* session = new Session(command, arguments, words);  // outlives signal handlers
  return command.run(arguments, *session);
}

int fail(std::string_view what, int status) {
  print_error_line("aktina: error: " + one_line(what));
  return status;
}

}  // namespace
}  // namespace aktina::app

int main(int argc, char** argv) {
  using namespace aktina;
  app::prepare_streams();
  try {
    return app::run(std::span<const char* const>(argv + (argc > 0), size_t(argc > 0 ? argc - 1 : 0)));
  } catch (const Error& error) {
    return app::fail(error.what(), info(error.code()).exit_status);
  } catch (const std::bad_alloc&) {
    return app::fail("not enough memory", info(Code::limit).exit_status);
  } catch (const std::exception& error) {
    return app::fail(fmt::format("unexpected: {}", error.what()), 1);
  }
}
