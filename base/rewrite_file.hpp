// Replacing a file that was read by what was made of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// From now on the file that `path` leads to is no input of this process: writing there destroys nothing that is
/// needed. Without effect where it was none.
void forget_input(const std::string& path);

/// Writes a text in the place of a file that was read: as `write_file` does, which refuses that.
void rewrite_file(const std::string& path, std::string_view text);

}  // namespace rmpl::base
