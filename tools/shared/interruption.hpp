// The end from outside: signals as a question that runs ask, or as an end that leaves nothing half done.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace rmpl::tools {

/// From now on a signal that ends the process first removes the files that were begun and not finished.
void clean_up_on_signals();

/// From now on the first SIGINT, SIGTERM or SIGHUP does not end the process but is noted: a run ends with what it has
/// found so far. The next one ends the process.
void watch_for_interruption();

/// Whether one was noted.
[[nodiscard]] bool interrupted();
[[nodiscard]] const std::atomic<bool>& interruption();

}  // namespace rmpl::tools
