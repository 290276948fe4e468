// What becomes of a program where no exception gets to its main: lack of memory, or a mistake of ours.
// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

namespace rmpl::tools {

// From before main on, an allocation that operator new or pugixml cannot make ends the program with a line on standard
// error and exit code 3, and so do std::terminate and a library's abort or null pointer after it; std::terminate for
// any other reason ends it with exit code 4.

/// Whether an exception says that memory was lacking: of operator new, or of a call of the system.
bool tells_lack_of_memory(const std::exception& error) noexcept;

/// From now on a library that calls `exit` by itself, as bliss does where it gets no memory, ends the program likewise.
void exit_is_a_failure() noexcept;

/// The program ends by itself: its exit code is its own.
void exit_is_ours() noexcept;

}  // namespace rmpl::tools
