// The attributes that a component type or a module declares become variables.
// SPDX-License-Identifier: MIT
#pragma once

#include "compiler/check/domains.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/ast/plant.hpp"

namespace rmpl::compiler {

/// Adds the variables of one declaration. A name that `names` has already is reported and left out, as are all names
/// where the domain is unknown.
void declare(Part& part, const grammar::AttributeDeclaration& declaration, Uniqueness& names, Domains& domains,
             grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
