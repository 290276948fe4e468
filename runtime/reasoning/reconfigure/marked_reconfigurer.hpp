// Reconfiguration of a model program behind the interface of plants, so that an executive can fly it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "automata/step/marked_plant.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// Groups of threads that the goal speaks of are planned for by themselves (marking_planner.hpp), and what is next of
/// all of them goes out at once, as long as they have no control in common and what each achieves lasts; else together.
/// Where one has no plan nothing is commanded. Goals are conjunctions of assignments; there is no housekeeping. Keeps
/// references to both.
std::unique_ptr<Reconfigurer> make_marked_reconfigurer(const automata::ModelProgram& program,
                                                       const automata::MarkedPlant& plant);

}  // namespace rmpl::runtime
