// Outcomes as JUnit XML, for continuous integration.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rmpl::base {

struct TestCase {
  /// A warning is no failure: its text is told beside. What is skipped says nothing, and `message` why.
  enum class Outcome { success, warning, failure, error, skipped };
  std::string name;
  std::string classname;
  double seconds;
  Outcome outcome;
  std::string message;                         ///< of what is no success
  std::string text;                            ///< what there is to show of it, lines ended
  std::string notes = {};                      ///< what is to be known of it, whatever its outcome; lines ended
  std::string file = {};                       ///< where it is stated, as the user named it; empty: nowhere
  std::uint32_t line = 0;                      ///< 0: none of it
  std::vector<std::string> requirements = {};  ///< that it verifies
};

struct TestSuite {
  std::string name;
  std::vector<TestCase> cases;
};

/// The case of what gave no answer, by the reason that was told: an error, whose message is the first line.
TestCase no_answer(std::string name, std::string classname, const std::string& reason);

/// Suites, each with how many of its cases have which outcome.
std::string to_junit(const std::vector<TestSuite>& suites);
/// One suite.
std::string to_junit(const std::string& suite, const std::vector<TestCase>& cases);

/// Suites as `to_junit` writes them: warnings come back as successes with notes, and notes of what is none in its text.
/// Throws InputError where the text is something else.
std::vector<TestSuite> read_junit(const std::string& text);

}  // namespace rmpl::base
