// What a model program has beside the locations and arcs of every program: what is told, and what is drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/logic/ids.hpp"
#include "grammar/source/span.hpp"

namespace rmpl::compiler {

/// A branch of a `choose` as written: what it starts, composites unopened and nested choices undrawn.
struct Branch {
  double probability;
  std::vector<automata::LocationId> starts;
};

/// By location; one that is missing tells nothing, or is no `choose`.
struct ModelParts {
  std::map<automata::LocationId, automata::Formula> told;
  std::map<automata::LocationId, std::vector<Branch>> choices;
};

}  // namespace rmpl::compiler
