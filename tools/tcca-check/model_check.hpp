// One property of a model program: which options it takes, its check, its answer. For reachability and safety.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tools/tcca-check/property_check.hpp"
#include "verifier/marking/question.hpp"

namespace rmpl::tools {

/// What is asked, where it may be asked of a model program too.
struct FormulaAsked {
  verifier::MarkingQuestion::Kind kind;
  const std::string& formula;
  const char* option;  ///< that the formula is given to
  const verifier::Window& window;
};

/// Checks it, and prints the answer. `title` is the property as it was asked. Throws base::InputError where an option
/// is about plants alone or no start is consistent, base::LimitError, Rejected.
ExitStatus check_model(const automata::ModelProgram& program, const PropertyOptions& options, const Common& common,
                       const std::string& title, const FormulaAsked& asked);

}  // namespace rmpl::tools
