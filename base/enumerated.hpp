// Lists in words.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rmpl::base {

/// `a, b and c`; `link` is the word before the last.
std::string enumerated(std::span<const std::string> names, std::string_view link = "and");

}  // namespace rmpl::base
