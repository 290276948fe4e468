// The locations of a model program that may be marked, by what may be told where they are.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "automata/phca.hpp"
#include "compiler/lint/model_program/told_stores.hpp"

namespace rmpl::compiler {

/// Per location, whether it may be marked: the least fixpoint of arcs whose guards may hold, by what the locations that
/// were found before may tell. One that is not among them is in no marking that can come about.
std::vector<bool> reachable_locations(const automata::ModelProgram& program, ToldStores& stores);

/// Per composite, the primitive locations that are marked with it, when it starts.
std::vector<std::vector<automata::LocationId>> started_together(const automata::ModelProgram& program);

}  // namespace rmpl::compiler
