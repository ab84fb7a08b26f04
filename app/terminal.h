// Standard output and standard error, and what a terminal there can show.
#pragma once

#include <string_view>

#include "aktina/base/progress.h"

namespace aktina::app {

/// Keeps the three standard streams from being taken by files that are opened later, and broken pipes from killing us.
void prepare_streams();

/// Writes all of it to standard output. A reader that went away (a broken pipe) has what it wants: not an error.
/// @throws Error io
void print(std::string_view text);
/// One line on standard error, above the progress bar if there is one; failures are ignored.
void print_error_line(std::string_view line);

enum class ProgressStyle { none, bar, lines, json };

/// What shows `progress` on standard error.
Progress::Watcher progress_watcher(ProgressStyle style);
bool error_is_terminal();

}  // namespace aktina::app
