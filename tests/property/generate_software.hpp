// Random software in random plants.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/logic/variables.hpp"
#include "automata/software/model_component.hpp"

namespace rmpl::property {

/// Every way to give each of these a value.
std::vector<std::vector<automata::Assignment>> all_assignments(const automata::Variables& variables,
                                                               const std::vector<automata::VariableId>& of);

/// Adds a random program as a component; its variables may be those of the plant.
void add_software(automata::PlantWithModels& whole, const std::string& name);

}  // namespace rmpl::property
