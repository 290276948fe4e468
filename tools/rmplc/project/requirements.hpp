// Which requirements the tests of a project verify.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "automata/origin.hpp"
#include "tools/rmplc/project/outcomes.hpp"

namespace rmpl::tools {

/// A requirement that a scenario, one of its expectations, or a property names.
struct RequirementTag {
  std::string requirement;
  std::string test;                        ///< the scenario, or the property
  std::optional<std::size_t> expectation;  ///< its position in the scenario; nothing: the whole test
  std::string text;                        ///< of the expectation, as written
  automata::Origin origin;                 ///< of what names it
};

/// What came of it, given all the tests that a call stands for. Of a test without an answer of its own, what came of
/// the call.
Verification verification_of(const RequirementTag& tag, const std::vector<ProjectTest>& tests);

/// Requirements by name, numbers in names by their value, each with what verifies it in the order that it is given; of
/// those that are listed perhaps nothing.
std::vector<Requirement> matrix_of(const std::vector<std::string>& listed,
                                   const std::vector<std::pair<std::string, Verification>>& verifications);

/// Names of those that nothing names, or nothing that passed.
std::vector<std::string> unverified(const std::vector<Requirement>& requirements);

/// `scenario`, `expectation`, `property`.
const char* kind_of(const Verification& one);
/// `burn.scn:12: finished within 30 s (fire and stop)`
std::string title_of(const Verification& one);

}  // namespace rmpl::tools
