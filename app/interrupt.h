// Ctrl-C and SIGTERM: the first stops the work and keeps the best result so far, the second ends the program at once.
#pragma once

#include "aktina/base/progress.h"

namespace aktina::app {

/// From now on signals end the program at once, leaving no partial file. `progress` must live until the program ends.
void watch_interrupts(Progress& progress);

/// From now on the first signal cancels `progress` instead: there is a result worth keeping.
void keep_result_when_interrupted();

}  // namespace aktina::app
