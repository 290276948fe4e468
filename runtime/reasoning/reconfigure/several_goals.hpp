// Goals that are asked for by themselves: which of them have a plan together (semantics 2, `each`).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "automata/step/program_rules.hpp"
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

namespace rmpl::runtime {

/// Goals that are left out in one cycle: they have no plan together with those that are pursued before them.
struct LeftOut {
  automata::Goals goals;
  Reason why;
  std::optional<automata::ComponentId> component;  ///< the one to blame, where there is one
  std::string reason;                              ///< in words
  bool operator==(const LeftOut&) const = default;
};

/// What a cycle does of what it is asked.
struct Pursued {
  automata::Goals goals;  ///< those that `answer` is about
  Reconfiguration answer;
  std::vector<LeftOut> left_out;  ///< in the order of the program
};

/// The goals that a program asserts in one cycle, in order: its own, and those of each branch; none empty.
std::vector<automata::Goals> goals_of(const automata::Asserted& asserted);

/// Asks for all goals together; where they have no plan, for one after the other: each that has none together with
/// those pursued before it is left out. Where none has a plan the first is pursued in vain: so a single one is never
/// left out. Without goals nothing is asked for. At most two questions for each goal, and one. `position`: what the
/// last answer led to.
Pursued pursue(Reconfigurer& reconfigurer, std::span<const automata::Modes> tracked,
               std::span<const automata::Goals> goals, const StrategyPosition& position = {});

/// Whether a goal without a plan speaks of a component: of its mode or of one of its attributes.
bool speaks_of(const automata::Goals& goals, automata::ComponentId component, const automata::Plant& plant);

/// The answer to `noplan`, and to `noplan(c)` where there is a component, about a cycle: what it pursued, with which
/// outcome, and what it left out.
bool no_plan(const automata::Goals& pursued, Reconfiguration::Outcome outcome, const std::vector<LeftOut>& left_out,
             std::optional<automata::ComponentId> component, const automata::Plant& plant);

}  // namespace rmpl::runtime
