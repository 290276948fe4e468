// Codes of the registry: what is allowed, and most likely meant otherwise.
// SPDX-License-Identifier: MIT
#include <array>

#include "grammar/source/code_tables.hpp"

namespace rmpl::grammar {
namespace {

constexpr std::array table = {
    CodeInfo{Code::duplicate_transition, "transition given twice",
             "Two transitions have the same source, target, guard and time bounds. Both count: their weights, risks or "
             "probabilities add up. One of them was most likely meant otherwise.",
             "off -> on when cmd = on;\noff -> on when cmd = on;", "off -> on when cmd = on;"},
};

}  // namespace

std::span<const CodeInfo> lint_codes() { return table; }

}  // namespace rmpl::grammar
