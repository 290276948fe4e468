// The variables that a component type, a module or a model program declares.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "compiler/check/domains.hpp"
#include "compiler/lower/part.hpp"
#include "grammar/ast/declaration.hpp"

namespace rmpl::compiler {

/// Adds variables of one domain. A name that `known` has already is reported and left out, as are all names where the
/// domain is unknown.
void declare(Part& part, const std::vector<grammar::Name>& names, const grammar::DomainRef& domain, Uniqueness& known,
             Domains& domains, grammar::Diagnostics& diagnostics);

}  // namespace rmpl::compiler
