// Words of the calendar where a length of time is expected.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rmpl::base {

/// Why `years` or `months` are no unit of time, as a sentence, with what to write; nothing for other words.
std::optional<std::string> calendar_reason(std::string_view unit);

}  // namespace rmpl::base
