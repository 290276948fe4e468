// The answers to a file of properties: as a table, as JSON (grammar/schema/verdicts.schema.json), as JUnit XML.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "automata/origin.hpp"
#include "automata/property.hpp"
#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::verifier {

/// A probability that is claimed, and what it was found to be.
struct Measure {
  automata::Ticks within = {};  ///< infinite: ever
  double bound = 0;
  bool at_least = false;
  double lower = 0, upper = 1;  ///< of what was found; unknown where the answer has a limit
  std::string text = {};        ///< the same for people
};

/// A property of a file, what is expected of it, and its answer.
struct Claim {
  std::string name;
  automata::Origin origin;  ///< where it is stated; no line: on the command line
  Question question;        ///< of a measure what is free, and the formula
  bool expect_violated = false;
  Answer answer;
  std::optional<Measure> measure = {};                             ///< where a probability is claimed
  std::optional<automata::PlantProperty::Severity> severity = {};  ///< of the failure that it excludes
  bool hazard = false;
  std::vector<std::string> requirements = {};  ///< that it verifies

  [[nodiscard]] bool of_program() const { return std::holds_alternative<ProgramProperty>(question.property); }
  [[nodiscard]] bool decided() const { return answer.verdict != Verdict::undecided; }
  /// Whether what came out is what was meant to.
  [[nodiscard]] bool as_expected() const {
    return answer.verdict == (expect_violated ? Verdict::violated : Verdict::holds);
  }
};

/// Of how many the verdict is as expected, another one, or missing.
struct Count {
  std::size_t expected = 0, unexpected = 0, undecided = 0;
};
Count count(const std::vector<Claim>& claims);

/// A line a property, with where it is stated; traces of those that are not as expected below their lines, and a line
/// that counts.
std::string to_table(const Subject& subject, const std::vector<Claim>& claims, bool statistics, bool color);
nlohmann::ordered_json to_json(const Subject& subject, const std::vector<Claim>& claims);
/// One suite, a test case a property: a failure where the verdict is not as expected, an error where there is none.
std::string to_junit(const Subject& subject, const std::vector<Claim>& claims);

}  // namespace rmpl::verifier
