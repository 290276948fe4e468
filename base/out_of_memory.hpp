// What becomes of a program that runs out of memory where nothing may be thrown.
// SPDX-License-Identifier: MIT
#pragma once

namespace rmpl::base {

/// A handler for std::terminate: exit code 3 and a line that says so where the reason is std::bad_alloc, 4 where it is
/// an InternalError, else abort. Most of the time std::bad_alloc reaches main; but the destructor of a JSON document
/// needs memory, too.
[[noreturn]] void end_for_lack_of_memory(const char* program) noexcept;

}  // namespace rmpl::base
