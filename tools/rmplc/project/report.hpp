// The answer of `rmplc test`, in every form.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "base/painter.hpp"
#include "tools/rmplc/project/outcomes.hpp"

namespace rmpl::tools {

/// How much a text for people tells.
enum class TestDetail { failures, usual, everything };

/// A line a test, with what failed and where below it; then how many there are of each outcome, and what nothing
/// touched, and which requirements are verified by what. `failures` leaves out what passed and the coverage;
/// `everything` tells all that was not touched, not the first.
std::string to_text(const ProjectOutcomes& outcomes, TestDetail detail, base::Painter painter);
/// grammar/schema/project_test.schema.json
std::string to_json(const ProjectOutcomes& outcomes);
/// A suite for lint of each set, and one for each file of a set, with the cases that the programs told.
std::string to_junit(const ProjectOutcomes& outcomes);
/// Workflow commands of GitHub Actions: findings of lint, expectations and properties that failed, where they stand.
std::string to_github(const ProjectOutcomes& outcomes);
/// Tables for the page of a job: counts by set, what failed, requirements, and coverage.
std::string to_markdown(const ProjectOutcomes& outcomes);

}  // namespace rmpl::tools
