// Why a program is held up, in words: a goal without a plan, an endless wait, what is undone, a response that is owed.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "verifier/property/property.hpp"
#include "verifier/verdict/subject.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// Each goal that the last cycle has no plan for, with its line, what bars the way and where the model says so, and
/// what would permit a plan.
std::string no_plan_text(const Subject& subject, const Witness& witness);

/// The locations that wait, and what keeps the components that they wait for where they are.
std::string waiting_text(const Subject& subject, const Witness& witness);

/// How a run goes on without end: what waits, or that it goes round.
std::string endless_text(const Subject& subject, const Witness& witness);

/// What is taken away, for which reward, and what would keep it.
std::string undone_text(const Subject& subject, const Witness& witness);

/// What has been owed since when.
std::string owed_text(const Subject& subject, const Response& response, const Witness& witness);

}  // namespace rmpl::verifier
