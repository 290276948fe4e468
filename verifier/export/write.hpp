// Networks of timed automata as the text of other tools.
// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>

#include "verifier/export/network.hpp"

namespace rmpl::verifier {

/// A system of a process a component, and one for the rounds, for TChecker; where the target is reached it comes to a
/// location with the label `target`: `tck-reach -a covreach -l target FILE` says REACHABLE true or false. Throws
/// base::InputError where a constant is beyond its 32 bits.
void write_tchecker(std::ostream& out, const automata::Plant& plant, const Network& network);

/// A system of a process a component, and one for the rounds, with its query for UPPAAL: `verifyta FILE` says whether
/// it is satisfied. Throws base::InputError where a constant is beyond its range.
void write_uppaal(std::ostream& out, const automata::Plant& plant, const Network& network);

/// A model of an automaton a component, and one for the rounds, with its property, in JANI: `pta`.
void write_jani(std::ostream& out, const automata::Plant& plant, const Network& network);

}  // namespace rmpl::verifier
