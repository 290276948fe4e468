// rmpl-run diagnose over a model program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "automata/phca.hpp"
#include "automata/state.hpp"
#include "tools/shared/exit_status.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// The `k` leading diagnoses of what is seen, none more than `ratio` times less likely than the best, printed. `path`
/// is the model's, for messages: where no start is consistent, it is refused.
ExitStatus diagnose_model(const automata::ModelProgram& program, const std::string& path,
                          const automata::Observation& observation, std::size_t k, double ratio, bool stats,
                          const Common& common);

}  // namespace rmpl::tools
