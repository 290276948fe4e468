// Testing a project: lint here, flights and checks by the other programs, several at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/rmplc/project/outcomes.hpp"
#include "tools/rmplc/project/plan.hpp"
#include "tools/shared/settings.hpp"

namespace rmpl::tools {

/// Runs a plan on so many threads; what comes back is the same for any number. Once interrupted nothing is begun.
/// Throws base::InputError where the other programs are not there, or the system gives no process.
ProjectOutcomes run_tests(const TestPlan& plan, const TestChoice& choice, const Settings& settings, unsigned jobs);

}  // namespace rmpl::tools
