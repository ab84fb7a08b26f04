// The subcommands: the only list.
#include "command.h"

namespace aktina::app {

extern const Command compare_command, render_command, methods_command, validate_command;

std::span<const Command* const> commands() {
  static constexpr const Command* kTable[] = {&compare_command, &render_command, &methods_command, &validate_command};
  return kTable;
}

}  // namespace aktina::app
