#pragma once

#include "command.h"

namespace aktina::app {

/// @param name  of the option or input, for messages
/// @throws Error usage, bad_param or no_such_method where `text` is no value for the option
void check_value(const Option& option, const std::string& name, const std::string& text);

}  // namespace aktina::app
