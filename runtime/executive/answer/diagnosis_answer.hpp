// The diagnoses of a snapshot, as they are told.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/diagnose/diagnose.hpp"

namespace rmpl::runtime {

/// The prior as a number that any reader of decimal numbers takes; also where it underflows a double.
std::string probability_text(const Diagnosis& diagnosis);

/// One object.
void write(JsonLine& json, const automata::Plant& plant, const Diagnoses& found);

/// The plant in which a component whose nominal mode is known is in no other nominal mode: it is in this one, or at
/// fault. Throws base::InputError where a name is no component or a mode is a fault.
automata::Plant with_known(automata::Plant plant, const std::vector<automata::Assignment>& modes);

}  // namespace rmpl::runtime
