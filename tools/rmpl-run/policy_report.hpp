// The policies of a plant, for people and for programs (thesis Table 6.2).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"

namespace rmpl::tools {

/// A table for each component: a block for each current mode, in it a line for each target mode. Where several
/// commands serve, the simplest is shown and the others are counted.
std::string policy_text(const automata::Plant& plant, const runtime::NominalGraph& graph,
                        const std::vector<automata::ComponentId>& components);

/// One object, every precondition of every entry (grammar/schema/policy.schema.json).
void write_policies(runtime::JsonLine& json, const automata::Plant& plant, const runtime::NominalGraph& graph,
                    const std::vector<automata::ComponentId>& components);

}  // namespace rmpl::tools
