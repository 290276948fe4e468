// Timed automata as the text of other tools.
// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>

#include "verifier/export/network.hpp"
#include "verifier/export/timed_automaton.hpp"

namespace rmpl::verifier {

/// A system of one process for TChecker; target locations have the label `target`:
/// `tck-reach -a covreach -l target FILE` says REACHABLE true or false. Throws base::InputError where a constant
/// is beyond its 32 bits.
void write_tchecker(std::ostream& out, const automata::Plant& plant, const TimedAutomaton& automaton);

/// A system of a process a component, and one for the rounds, with its query for UPPAAL: `verifyta FILE` says whether
/// it is satisfied. Throws base::InputError where a constant is beyond its range.
void write_uppaal(std::ostream& out, const automata::Plant& plant, const Network& network);

/// A model of an automaton a component, and one for the rounds, with its property, in JANI: `pta`.
void write_jani(std::ostream& out, const automata::Plant& plant, const Network& network);

}  // namespace rmpl::verifier
