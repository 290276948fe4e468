// Which requirements are verified by what is tested, as written (grammar/scn.ebnf, grammar/props.ebnf).
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "grammar/ast/token.hpp"

namespace rmpl::grammar {

/// `requirement "FDIR-12", "FDIR-13";`, of a scenario or a property; of an expectation without `;`.
struct RequirementPart {
  Span span;
  std::vector<String> tags;
};

}  // namespace rmpl::grammar
