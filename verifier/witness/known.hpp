// What a run tells of the executive's knowledge, by the store that remembers nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/store/plain_store.hpp"
#include "runtime/reasoning/reconfigure/several_goals.hpp"
#include "verifier/property/known_truth.hpp"
#include "verifier/witness/witness.hpp"

namespace rmpl::verifier {

/// What the planner answered in a cycle.
struct Answered {
  automata::Goals goals;
  runtime::Reconfiguration::Outcome outcome;
  std::vector<runtime::LeftOut> left_out;
};

/// The answer to an atom in the modes that a cycle has led to; null: the start, which none has led to.
inline bool is_known_after(automata::PlainStore& store, const automata::Formula& atom, const automata::Modes& modes,
                           const Answered* cycle) {
  return is_known(
      atom, [&](const automata::Formula& formula) { return store.implies(formula, modes); },
      [&](const automata::Formula& formula) { return store.allows(formula, modes); },
      [&](const automata::Formula& asked) {
        const auto component = asked.about_one ? store.plant().component_of(asked.variable) : std::nullopt;
        return cycle != nullptr &&
               runtime::no_plan(cycle->goals, cycle->outcome, cycle->left_out, component, store.plant());
      });
}

}  // namespace rmpl::verifier
