// One property of a model program: which options it takes, its check, its answer. For reachability and safety.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tools/tcca-check/property_check.hpp"
#include "verifier/marking/question.hpp"

namespace rmpl::tools {

/// For the help of what takes model programs.
inline constexpr const char* model_notes =
    R"(MODEL may be a model program (.rmpl). It moves in steps of a second, or of --time T, and what has a positive probability
can happen. --faults and --fewest-faults then count improbable draws, of a branch that another one is likelier than:
any number, unless --faults is given.)";

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
