// The cone of influence: the components that can have to do with a question.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "automata/step/plant_step.hpp"

namespace rmpl::verifier {

/// By component: whether it is one that decides some of the formulas, or that a guard of one in the cone depends on, or
/// that shares an island of the constraint store with one in the cone; also where a control action could contradict its
/// island, as a store that contradicts itself enables everything.
///
/// What is outside never enables, forces or forbids anything inside. With it frozen, time passing as if it were not
/// there, the cone does all that it can do in the whole plant, and perhaps more: what outside stops time, or must move
/// while the cone waits, is not felt.
std::vector<bool> cone_of_influence(automata::PlantStep& step, std::span<const automata::Formula> formulas);

}  // namespace rmpl::verifier
