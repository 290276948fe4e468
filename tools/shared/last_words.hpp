// What becomes of a program where no exception gets to its main: lack of memory, or a mistake of ours.
// SPDX-License-Identifier: MIT
#pragma once

namespace rmpl::tools {

/// From now on std::terminate, and a library that calls `exit` by itself, end with a line on standard error and exit
/// code 3 for lack of memory, 4 for anything else. Most of the time std::bad_alloc reaches main; but the destructor of
/// a JSON document needs memory, too, and bliss exits where it gets none.
void end_with_last_words(const char* program) noexcept;

/// The program ends by itself: its exit code is its own.
void exit_is_ours() noexcept;

}  // namespace rmpl::tools
