// Writing a result: the whole of it, or nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rmpl::base {

/// Writes a text under a name, replacing what was there: into a file beside it, which then takes the name, so that no
/// reader ever sees a part. What is no regular file (a terminal, a pipe, /dev/null) is written to directly. Throws
/// InputError where it cannot be written; then what was there before is still there.
void write_file(const std::string& path, const std::string& text);

}  // namespace rmpl::base
