// Threads that do the same work until there is none left.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "base/function_ref.hpp"

namespace rmpl::base {

/// Calls `work` in this thread and in `threads - 1` others, fewer where the system gives no more, and returns once all
/// calls have ended. Throws what a call threw: of several the first in time.
void work_together(std::size_t threads, FunctionRef<void()> work);

/// Calls `task` with each of the numbers up to `count`, handed out in ascending order; a call gets the number of its
/// thread, below `threads`, too. Once one throws no other is begun, and what the task of the least number threw is
/// thrown: which, does not depend on the threads, since all before it have been begun.
void share_tasks(std::size_t threads, std::size_t count, FunctionRef<void(std::size_t task, std::size_t thread)> task);

}  // namespace rmpl::base
