// The engines of an executive, by what a command line says of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "runtime/executive/scenario/run.hpp"

namespace rmpl::runtime {

/// Mode estimation as the executive uses it: the clock of a mode without a timed exit is forgotten. Keeps a reference
/// to `step`.
std::unique_ptr<Estimator> make_estimator(automata::PlantStep& step, const ScenarioOptions& options);

/// Mode reconfiguration. Keeps a reference to `step`.
std::unique_ptr<Reconfigurer> make_recovery(automata::PlantStep& step, const ScenarioOptions& options);

}  // namespace rmpl::runtime
