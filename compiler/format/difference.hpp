// What formatting changes, as people and `patch` read it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::compiler {

/// The unified difference of a text and its layout, with three lines of context; empty where they are equal. Both hold
/// the same characters but for blanks, so that lines belong together where as many characters stand before them: no
/// search, linear.
std::string layout_difference(std::string_view before, std::string_view after, const std::string& name);

}  // namespace rmpl::compiler
