// A strategy as text, as JSON and as a picture for Graphviz.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/game/strategy.hpp"

namespace rmpl::tools {

/// `sure`, `fair`, `hoped`, `none`.
std::string_view word_for(runtime::Rank rank);

/// A block for each node: its modes, what is sent there, and where that leads.
std::string strategy_text(const automata::Plant& plant, const runtime::Strategy& strategy);

/// One object (grammar/schema/strategy.schema.json).
void write_strategy(runtime::JsonLine& json, const automata::Plant& plant, const runtime::Strategy& strategy);

/// A directed graph in DOT: nodes with the modes that differ somewhere in the strategy, edges with what happened.
std::string strategy_dot(const automata::Plant& plant, const runtime::Strategy& strategy);

}  // namespace rmpl::tools
