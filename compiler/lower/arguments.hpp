// What the parameters of an expansion stand for.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <variant>

#include "grammar/ast/program.hpp"

namespace rmpl::compiler {

struct Environment;

/// A constraint that was passed, with what its own names stand for.
struct PassedConstraint {
  const grammar::Constraint* constraint;
  const Environment* environment;
  std::string text;  ///< with all parameters replaced: equal texts are equal arguments
};

/// Stands for anything: the parameters of a definition that nothing calls, which is checked all the same.
struct Anything {};

using Passed = std::variant<grammar::Name, PassedConstraint, Anything>;

/// The parameters and clocks of one expansion of a definition.
struct Environment {
  std::map<std::string, Passed, std::less<>> parameters;
  std::map<std::string, grammar::Name, std::less<>> clocks;  ///< its own, and what they are called in the automaton
  const grammar::Call* call = nullptr;                       ///< where the expansion comes from, for messages
};

}  // namespace rmpl::compiler
