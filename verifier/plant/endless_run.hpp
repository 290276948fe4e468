// Runs of a plant that go on without end and without what is to come some day.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "verifier/plant/plant_system.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// A run on which a response is owed and never comes, as it goes round for ever; its round is the last part of it.
/// `system` watches progress, has an observer without a deadline and no symmetry, and exits are told. The components
/// that move in it read the same where it begins and ends, if that comes about within a few rounds. Throws
/// LimitReached.
std::optional<Witness> find_endless_run(PlantSystem& system, Meter& meter);

/// The run with a last event in which nothing has changed, and from there on nothing does: `step` is how long that
/// takes.
Witness resting(Witness witness, const automata::Plant& plant, automata::Ticks step);

}  // namespace rmpl::verifier
