// How far a long run has come, on a terminal.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace rmpl::tools {

/// Whether there is somebody to show progress to: standard error is a terminal, and the user did not ask for quiet.
bool progress_is_seen(bool quiet);

/// Rewrites the one line of progress on standard error. Whatever is printed next erases it first.
void show_progress(std::string_view line);
void erase_progress();

}  // namespace rmpl::tools
