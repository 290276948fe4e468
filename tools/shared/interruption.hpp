// SIGINT as a question: a run asks it between two cycles, and ends with what it has found.
// SPDX-License-Identifier: MIT
#pragma once

namespace rmpl::runtime {

/// From now on SIGINT does not kill the process; a second one does.
void watch_for_interruption();
[[nodiscard]] bool interrupted();

}  // namespace rmpl::runtime
