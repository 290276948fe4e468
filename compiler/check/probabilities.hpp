// Probabilities: each in [0, 1], and together at most 1 wherever they can apply together.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/token.hpp"
#include "grammar/source/diagnostic.hpp"

namespace rmpl::compiler {

/// Sums of written decimals are compared with 1 up to this.
inline constexpr double probability_tolerance = 1e-9;

/// A number for messages, with at most six significant digits.
std::string decimal(double value);

/// Whether a written probability is in [0, 1]; reports it where it is not, with what helps where it is a whole
/// number above.
bool check_probability(const grammar::Number& probability, grammar::Diagnostics& diagnostics,
                       const char* whole = nullptr);

/// The probabilities that the numbers of one list mean, in its order: the numbers themselves, which sum to 1; or, where
/// a whole number above 1 is among them, their shares in the sum of all. Nothing where they are neither; then that has
/// been reported, a sum below 1 as `below`. `of`: what is drawn, for messages: "branch", "initial".
std::optional<std::vector<double>> probabilities_of(const std::vector<const grammar::Number*>& numbers,
                                                    grammar::Span list, grammar::Code below, const std::string& of,
                                                    grammar::Diagnostics& diagnostics);

/// Reports each mode of a component type, a plant of one component, whose fault probabilities sum above 1, and whose
/// guards can hold together under the mode's constraint: found by proof, so that exclusive guards are no error. `spans`
/// has the place of each transition, `modes` of each mode.
void check_fault_sums(const automata::Plant& type, const std::vector<grammar::Span>& spans,
                      const std::vector<grammar::Span>& modes, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
