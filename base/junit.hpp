// Outcomes as JUnit XML, for continuous integration.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace rmpl::base {

struct TestCase {
  enum class Outcome { success, warning, failure, error };  ///< a warning is no failure: its text is told beside
  std::string name;
  std::string classname;
  double seconds;
  Outcome outcome;
  std::string message;     ///< of a failure or an error
  std::string text;        ///< what there is to show of it, lines ended
  std::string notes = {};  ///< what is to be known of it, whatever its outcome; lines ended
};

struct TestSuite {
  std::string name;
  std::vector<TestCase> cases;
};

/// Suites, each with how many of its cases have which outcome.
std::string to_junit(const std::vector<TestSuite>& suites);
/// One suite.
std::string to_junit(const std::string& suite, const std::vector<TestCase>& cases);

}  // namespace rmpl::base
