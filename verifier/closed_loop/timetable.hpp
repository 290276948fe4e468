// Timetables: concrete times for a symbolic path of the closed loop.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "verifier/closed_loop/program_system.hpp"
#include "verifier/search/search.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// The run with the earliest times of a path of `ProgramSystem` to what the query looks for.
Witness earliest_witness(const std::vector<PathState>& path, Loop& loop, const Query& query,
                         const std::optional<PathEnd>& end = std::nullopt);

}  // namespace rmpl::verifier
