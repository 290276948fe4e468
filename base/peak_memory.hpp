// How much memory this process has taken.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace rmpl::base {

/// The greatest resident memory of this process so far, in bytes. A system call.
std::size_t peak_memory();

}  // namespace rmpl::base
