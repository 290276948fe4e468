// The answers to a file of properties: as a table, as JSON (grammar/schema/verdicts.schema.json), as JUnit XML.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verifier/verdict/answer.hpp"
#include "verifier/verdict/subject.hpp"

namespace rmpl::verifier {

/// A property of a file, what is expected of it, and its answer.
struct Claim {
  std::string name;
  Question question;
  bool expect_violated = false;
  Answer answer;

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

/// A line a property, traces of those that are not as expected below their lines, and a line that counts.
std::string to_table(const Subject& subject, const std::vector<Claim>& claims, bool statistics, bool color);
nlohmann::ordered_json to_json(const Subject& subject, const std::vector<Claim>& claims);
/// One suite, a test case a property: a failure where the verdict is not as expected, an error where there is none.
std::string to_junit(const Subject& subject, const std::vector<Claim>& claims);

}  // namespace rmpl::verifier
