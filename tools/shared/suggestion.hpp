// The suggestion for an unknown name: the nearest known one, or a list.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rmpl::tools {

/// `; did you mean 'engine'?`, or where none is near `; expected 'a', 'b' or 'c'`, to end a message with. Of more than
/// 24 names it tells how many there are, and five.
std::string suggestion_or_list(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace rmpl::tools
