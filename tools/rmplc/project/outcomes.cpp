// Counting outcomes.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/outcomes.hpp"

#include <algorithm>

namespace rmpl::tools {

using Outcome = ProjectTest::Outcome;

std::size_t ProjectOutcomes::count(Outcome outcome) const {
  return static_cast<std::size_t>(
      std::count_if(tests.begin(), tests.end(), [&](const ProjectTest& test) { return test.outcome == outcome; }));
}

ExitStatus ProjectOutcomes::status() const {
  Outcome worst = Outcome::passed;
  for (const ProjectTest& test : tests) worst = std::max(worst, test.outcome);
  for (const Requirement& one : requirements) worst = std::max(worst, one.outcome());
  switch (worst) {
    case Outcome::passed:
      return ExitStatus::done;
    case Outcome::skipped:
    case Outcome::undecided:
      return ExitStatus::undecided;
    case Outcome::failed:
      return ExitStatus::violated;
    case Outcome::wrong:
      return ExitStatus::wrong_input;
    case Outcome::broken:
      break;
  }
  return ExitStatus::internal_error;
}

Outcome outcome_of(const base::TestCase& one) {
  switch (one.outcome) {
    case base::TestCase::Outcome::success:
    case base::TestCase::Outcome::warning:
      return Outcome::passed;
    case base::TestCase::Outcome::failure:
      return Outcome::failed;
    case base::TestCase::Outcome::error:
      return Outcome::undecided;
    case base::TestCase::Outcome::skipped:
      break;
  }
  return Outcome::skipped;
}

bool is_good(const base::TestCase& one) {
  return one.outcome == base::TestCase::Outcome::success || one.outcome == base::TestCase::Outcome::warning;
}

const char* to_string(ProjectTest::Kind kind) {
  switch (kind) {
    case ProjectTest::Kind::lint:
      return "lint";
    case ProjectTest::Kind::scenario:
      return "scenario";
    case ProjectTest::Kind::property:
      return "property";
  }
  return "";
}

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::passed:
      return "passed";
    case Outcome::skipped:
      return "skipped";
    case Outcome::undecided:
      return "undecided";
    case Outcome::failed:
      return "failed";
    case Outcome::wrong:
      return "wrong";
    case Outcome::broken:
      return "broken";
  }
  return "";
}

std::string title_of(const ProjectTest& test) {
  if (test.kind == ProjectTest::Kind::lint) return "lint of " + test.set;
  return test.name.empty() ? test.file : test.file + ": " + test.name;
}

}  // namespace rmpl::tools
