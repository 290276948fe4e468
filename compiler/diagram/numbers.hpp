// Numbers of a plant as the language writes them, in as few characters as say the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"

namespace rmpl::compiler {

/// The shortest decimal that reads back the same: `0.001`, `1e-6`.
std::string shortest(double value);

/// `in [30 s, 60 s]`, `after 5 s`, with a density that is not uniform behind it.
std::string to_text(const automata::Timing& timing);

/// `with 0.01`; a rate in the unit of time in which it is shortest, of equally short ones per hour: `with rate 1e-4
/// /h`. Empty where there is no weight.
std::string to_text(const automata::Weight& weight);

}  // namespace rmpl::compiler
