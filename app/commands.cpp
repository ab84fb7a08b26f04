// The subcommands: the only list.
#include "command.h"

namespace aktina::app {

extern const Command methods_command;

std::span<const Command* const> commands() {
  static constexpr const Command* kTable[] = {&methods_command};
  return kTable;
}

}  // namespace aktina::app
