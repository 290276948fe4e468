// What conditions ask of an executive's knowledge, where its estimate is the truth (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/logic/formula.hpp"

namespace rmpl::verifier {

/// The answer to one atom in a state: `likely` is entailment, `possible` consistency, and nothing is a surprise.
/// `implies(φ)` and `allows(φ)` answer for the store of the state, `no_plan(atom)` for the cycle that led to it.
template <class Implies, class Allows, class NoPlan>
bool is_known(const automata::Formula& atom, const Implies& implies, const Allows& allows, const NoPlan& no_plan) {
  switch (atom.knowing) {
    case automata::Knowing::surprise:
      return false;
    case automata::Knowing::no_plan:
      return no_plan(atom);
    case automata::Knowing::possible:
      return allows(atom.operands.front());
    case automata::Knowing::likely:
      return implies(atom.operands.front());
  }
  return false;
}

}  // namespace rmpl::verifier
