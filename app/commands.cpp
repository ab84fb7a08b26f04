// The subcommands: the only list.
#include "command.h"

namespace aktina::app {

extern const Command render_command, radiosity_command, bake_command, study_command, compare_command, info_command,
    methods_command, validate_command, viewfactors_command, illuminance_command;

std::span<const Command* const> commands() {
  static constexpr const Command* kTable[] = {
      &render_command, &radiosity_command, &bake_command,     &study_command,       &compare_command,
      &info_command,   &methods_command,   &validate_command, &viewfactors_command, &illuminance_command};
  return kTable;
}

}  // namespace aktina::app
