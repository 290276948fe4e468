// From tags and outcomes to the matrix.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/requirements.hpp"

#include <algorithm>
#include <cstring>
#include <map>

namespace rmpl::tools {

using Outcome = ProjectTest::Outcome;

namespace {

/// `FDIR-2` before `FDIR-12`.
struct ByNumber {
  bool operator()(const std::string& a, const std::string& b) const {
    const int order = ::strverscmp(a.c_str(), b.c_str());
    return order != 0 ? order < 0 : a < b;
  }
};

}  // namespace

Outcome Requirement::outcome() const {
  Outcome worst = by.empty() ? Outcome::failed : Outcome::passed;
  for (const Verification& one : by) worst = std::max(worst, one.outcome);
  return worst;
}

bool Requirement::verified() const {
  return std::any_of(by.begin(), by.end(), [](const Verification& one) { return one.outcome == Outcome::passed; });
}

Verification verification_of(const RequirementTag& tag, const std::vector<ProjectTest>& tests) {
  const auto named =
      std::find_if(tests.begin(), tests.end(), [&](const ProjectTest& test) { return test.name == tag.test; });
  const ProjectTest& test = named == tests.end() ? tests.front() : *named;
  Verification result{.kind = test.kind,
                      .set = test.set,
                      .file = tag.origin.file,
                      .line = tag.origin.line,
                      .test = tag.test,
                      .expectation = tag.expectation ? tag.text : std::string(),
                      .outcome = test.outcome};
  // A wrong input and an interruption are of all that the test expects.
  const bool judged = test.outcome != Outcome::wrong && test.outcome != Outcome::broken;
  if (tag.expectation && judged && *tag.expectation < test.cases.size()) {
    result.outcome = outcome_of(test.cases[*tag.expectation]);
  }
  return result;
}

std::vector<Requirement> matrix_of(const std::vector<std::string>& listed,
                                   const std::vector<std::pair<std::string, Verification>>& verifications) {
  std::map<std::string, Requirement, ByNumber> by_name;
  for (const std::string& name : listed) by_name[name];
  for (const auto& [name, one] : verifications) by_name[name].by.push_back(one);
  std::vector<Requirement> result;
  for (auto& [name, requirement] : by_name) {
    requirement.name = name;
    result.push_back(std::move(requirement));
  }
  return result;
}

std::vector<std::string> unverified(const std::vector<Requirement>& requirements) {
  std::vector<std::string> names;
  for (const Requirement& one : requirements) {
    if (!one.verified()) names.push_back(one.name);
  }
  return names;
}

const char* kind_of(const Verification& one) { return one.expectation.empty() ? to_string(one.kind) : "expectation"; }

std::string title_of(const Verification& one) {
  const std::string place = one.file + (one.line > 0 ? ":" + std::to_string(one.line) : "") + ": ";
  return place + (one.expectation.empty() ? one.test : one.expectation + " (" + one.test + ")");
}

}  // namespace rmpl::tools
