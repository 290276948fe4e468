// Text from outside on a terminal: a name must not move the cursor, or colour what follows.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace rmpl::base {

/// Whether a byte is a control character of ASCII: below the blank, or delete.
constexpr bool is_control(char byte) { return static_cast<unsigned char>(byte) < 0x20 || byte == 0x7f; }

/// The text with every control character but the end of a line as `\x1b`.
std::string printable(std::string_view text);

}  // namespace rmpl::base
