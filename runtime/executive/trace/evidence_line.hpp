// The evidence of diagnoses, as objects of a trace and as words of a story.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/explain/evidence.hpp"

namespace rmpl::runtime {

/// The key `evidence` and its array; nothing where there is none. `estimate` is the one that has the diagnoses.
void write_evidence(JsonLine& line, const std::vector<Evidence>& evidence, const automata::Modes& estimate,
                    const automata::Plant& plant);

/// The kind of a name in such an array; `outweighed` where it is none.
Evidence::Kind evidence_named(std::string_view name);

/// `temp = low contradicts engine = heating (lander.tcca:12)`: part of a sentence, on one line.
std::string to_text(const Evidence& evidence, const automata::Modes& estimate, const automata::Plant& plant);

}  // namespace rmpl::runtime
