// Conditions over modes and controls in the notation of C, which several tools share.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "automata/logic/formula.hpp"
#include "automata/plant.hpp"

namespace rmpl::verifier {

/// What a tool calls a variable: `m[3]`.
using NameOf = std::function<std::string(automata::VariableId)>;

/// The values as numbers: `m[3] == 1 && (u[0] != 2 || m[4] <= 1)`. Has connectives of members, and constants.
std::string condition_text(const automata::Formula& formula, const automata::Plant& plant, const NameOf& name_of);

/// A name with letters, digits and `_` alone, which begins with a letter.
std::string identifier(const std::string& name);

}  // namespace rmpl::verifier
