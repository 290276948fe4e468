// The transition trees of a model program: nested choices distributed and merged to two levels (ijcai01, "Probabilistic
// HCA"), and which choices are drawn before time 0 (semantics 8).
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "automata/phca.hpp"
#include "automata/program.hpp"
#include "compiler/lower/model_parts.hpp"

namespace rmpl::compiler {

/// What the choices of a program come to.
struct Draws {
  std::map<automata::LocationId, std::vector<automata::TransitionFunction>> functions;  ///< per choice
  std::vector<automata::InitialDraw> initial;                                           ///< by location
  std::vector<bool> first;  ///< per location: a choice that is drawn before time 0, by itself or with one around it
  /// A choice whose branches multiply beyond bounds: then the rest means nothing.
  std::optional<automata::LocationId> too_large;
};

/// Branches of probability 0 are left out. Cost and size are those of the products.
Draws draws_of(const automata::Program& program, const ModelParts& parts);

}  // namespace rmpl::compiler
