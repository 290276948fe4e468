// Fault trees as text, as JSON (grammar/schema/fault_tree.schema.json), in the Open-PSA format, and as a drawing.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verifier/safety/fault_tree.hpp"

namespace rmpl::verifier {

std::string to_text(const automata::Plant& plant, const FaultTreeQuestion& question, const FaultTree& tree,
                    const std::string& asked);
nlohmann::ordered_json to_json(const automata::Plant& plant, const FaultTreeQuestion& question, const FaultTree& tree,
                               const std::string& asked);

/// The listed sets as a tree of the Open-PSA Model Exchange Format: the top event is one of them, each is all of its
/// faults. Rates are per hour, as SCRAM counts its mission time, and the file says so; a fault that hangs on guards has
/// no probability.
std::string to_open_psa(const automata::Plant& plant, const FaultTreeQuestion& question, const FaultTree& tree);
/// The same in DOT.
std::string to_dot(const automata::Plant& plant, const FaultTree& tree, const std::string& asked);

}  // namespace rmpl::verifier
