// What came of the tests of a project: one list, of which every form of the answer is made.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/junit.hpp"
#include "grammar/source/findings.hpp"
#include "runtime/report/coverage.hpp"
#include "tools/shared/exit_status.hpp"

namespace rmpl::tools {

/// A test that people count: lint of a set, a scenario, a property.
struct ProjectTest {
  enum class Kind { lint, scenario, property };
  enum class Outcome {
    passed,
    skipped,    ///< it was not begun, as an interruption came before
    undecided,  ///< a limit or an interruption ended it
    failed,
    wrong,  ///< an input is
    broken  ///< the program that was called failed
  };
  Kind kind = Kind::lint;
  Outcome outcome = Outcome::passed;
  std::string set;
  std::string file;  ///< of lint: none
  std::string name;  ///< likewise
  double seconds = 0;
  std::vector<base::TestCase> cases = {};  ///< of lint, findings; of a scenario, its expectations
};

/// A scenario, an expectation or a property that verifies a requirement, and what came of it.
struct Verification {
  ProjectTest::Kind kind = ProjectTest::Kind::scenario;  ///< of an expectation: that of its scenario
  std::string set;
  std::string file;
  std::uint32_t line = 0;
  std::string test;         ///< the scenario, or the property
  std::string expectation;  ///< as written; empty: the test as a whole
  ProjectTest::Outcome outcome = ProjectTest::Outcome::passed;
};

/// A requirement that the tests name, or the manifest lists, with all that verifies it.
struct Requirement {
  std::string name;
  std::vector<Verification> by = {};

  /// The worst of what names it; where nothing does, that is a failure.
  [[nodiscard]] ProjectTest::Outcome outcome() const;
  /// Whether something that names it passed.
  [[nodiscard]] bool verified() const;
};

/// What lint found in a set, and the texts that it speaks of.
struct SetFindings {
  grammar::Sources sources;
  std::vector<grammar::Diagnostic> found;
};

struct ProjectOutcomes {
  std::string project;             ///< its name, or where it is
  std::vector<ProjectTest> tests;  ///< in the order of the manifest
  std::vector<SetFindings> lint;
  std::vector<runtime::CoverageItem> coverage;  ///< what flights and traces came to
  std::vector<Requirement> requirements = {};   ///< that the tests name or the manifest lists, by name
  double seconds = 0;

  [[nodiscard]] std::size_t count(ProjectTest::Outcome outcome) const;
  /// The worst of all outcomes, requirements that nothing names among them: a broken program outweighs a wrong input,
  /// that a failure, that what is undecided or was not begun.
  [[nodiscard]] ExitStatus status() const;
};

/// What a case is of a scenario or a property: one without an answer is undecided.
ProjectTest::Outcome outcome_of(const base::TestCase& one);
/// Whether nothing is to be told of the case.
bool is_good(const base::TestCase& one);
/// `lint`, `scenario`, `property`.
const char* to_string(ProjectTest::Kind kind);
/// `passed`, `skipped`, `undecided`, `failed`, `wrong`, `broken`.
const char* to_string(ProjectTest::Outcome outcome);
/// `lint of burn`, `burn.scn: fire and stop`.
std::string title_of(const ProjectTest& test);

}  // namespace rmpl::tools
