// Labels and maintenance constraints as JSON, and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "automata/json/document.hpp"
#include "automata/program.hpp"

namespace rmpl::automata {

/// {"entailed": formula} or {"not_entailed": formula}.
Json condition_to_json(const Condition& condition, const Variables& variables,
                       std::span<const std::string> clocks = {});
Condition condition_from_json(const Node& node, const Variables& variables, std::span<const std::string> clocks = {});

}  // namespace rmpl::automata
