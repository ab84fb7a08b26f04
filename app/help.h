// Parts of the help that the man page and the completion scripts share.
#pragma once

#include "command.h"

namespace aktina::app {

std::string option_term(const Option& option);  // "-o, --output FILE"
std::string option_text(const Option& option);  // help, choices and default
std::string usage_line(const Command& command);

}  // namespace aktina::app
