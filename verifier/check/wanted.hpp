// What is looked for in a plant, whatever the property.
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "verifier/property/property.hpp"
#include "verifier/slice/part.hpp"

namespace rmpl::verifier {

/// A state to reach.
struct Target {
  automata::Formula formula;
  Window window;
  bool fastest = false;
};
/// A target to reach, a response to miss, or a dead end.
using Wanted = std::variant<Target, Response, Stuck>;

Wanted wanted_of(const Property& property);
/// What it reads.
std::vector<automata::Formula> formulas_of(const Wanted& wanted);
/// The finite times that it names.
std::vector<automata::Ticks> times_of(const Wanted& wanted);
/// The same in the terms of a part of the plant.
Wanted into(const Part& part, Wanted wanted);

}  // namespace rmpl::verifier
