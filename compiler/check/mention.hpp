// Where a constraint speaks of a variable.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "grammar/ast/constraint.hpp"

namespace rmpl::compiler {

/// The first place in a constraint where this name stands as a variable; where there is none, all of it.
grammar::Span mention_of(std::string_view variable, const grammar::Constraint& constraint);

}  // namespace rmpl::compiler
