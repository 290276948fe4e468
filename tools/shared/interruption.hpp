// The end from outside: signals as a question that runs ask, or as an end that leaves nothing half done.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace rmpl::tools {

/// From now on SIGINT, SIGTERM, SIGHUP and SIGXCPU are noted, however many come: a run asks, and ends with what it has
/// found so far. GNU timeout sends its signal twice, and other services one after another, so that a count of signals
/// says nothing. Who sits at a terminal can break off by force: a Ctrl-C (SIGINT) that is at least the third signal and
/// comes at least a second after the first ends the process. Whatever ends it first removes the files that were begun
/// and not finished. `name` is the program's, for the last message; it outlives the process.
void note_signals(const char* name);

/// From now on the first of these signals ends the process with `interrupted` on standard error and exit code 3, for
/// there is nothing to tell before the end. One that was noted already does so at once.
void end_at_signals();

/// Whether one was noted.
[[nodiscard]] bool interrupted();
[[nodiscard]] const std::atomic<bool>& interruption();

}  // namespace rmpl::tools
