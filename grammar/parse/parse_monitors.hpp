// From text to trees: monitors.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "grammar/ast/monitor.hpp"
#include "grammar/parse/parse.hpp"

namespace rmpl::grammar {

/// A `.mon` file (grammar/mon.ebnf).
Parse<MonitorFile> parse_monitors(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);

}  // namespace rmpl::grammar
