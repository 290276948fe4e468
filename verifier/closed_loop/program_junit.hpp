// Results about programs as JUnit XML.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "verifier/closed_loop/program_report.hpp"

namespace rmpl::verifier {

/// A test case a property: a failure where it is violated, an error where it is undecided. All were decided together,
/// and the first case has the time.
std::string to_junit(const ProgramSubject& subject, const std::vector<ProgramProperty>& properties,
                     const ProgramResult& result);
/// A test case a fault, and one for none: a failure where it can lose the mission, or keep the program from ending.
std::string to_junit(const ProgramSubject& subject, const FaultTable& table);

}  // namespace rmpl::verifier
