// The rule of whole `.mon` files.
// SPDX-License-Identifier: MIT
#pragma once

#include "grammar/ast/monitor.hpp"
#include "grammar/parse/rules.hpp"

namespace rmpl::grammar {

inline constexpr Rule<struct MonitorFileId, MonitorFile> monitor_file{"a channel"};
BOOST_SPIRIT_DECLARE(decltype(monitor_file))

}  // namespace rmpl::grammar
