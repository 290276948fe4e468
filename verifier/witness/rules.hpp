// What one component may do, by exact comparison: the words of semantics 3 and 7, apart from all that searches.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "automata/step/transition_rules.hpp"

namespace rmpl::verifier {

/// Decided for one reading of the component's clock.
class Rules {
 public:
  /// `before` and `now` are clock readings; in dense time they are the same, but where time passes.
  Rules(const automata::Component& component, const automata::Enabled& enabled, automata::Ticks before,
        automata::Ticks now, std::optional<automata::Ticks> period)
      : component_(component), enabled_(enabled), before_(before), now_(now), period_(period) {}

  [[nodiscard]] bool allows(automata::ModeId from, automata::ModeId to) const {
    const auto& faults = enabled_.faults;
    return std::any_of(faults.begin(), faults.end(),
                       [&](automata::TransitionId id) { return transition(id).to == to && is_due(transition(id)); }) ||
           allows_without_fault(from, to);
  }

  [[nodiscard]] bool allows_without_fault(automata::ModeId from, automata::ModeId to) const {
    if (automata::nominal_share(component_, enabled_, now_, period_.value_or(automata::Ticks{0})) == 0) return false;
    if (!enabled_.untimed.empty()) return leads(enabled_.untimed, to, [](const automata::Transition&) { return true; });
    if (!period_) {
      const bool some_passed =
          std::any_of(enabled_.timed.begin(), enabled_.timed.end(),
                      [&](automata::TransitionId id) { return now_ > transition(id).timing->upper; });
      return (from == to && !some_passed) || leads(enabled_.timed, to, [&](const automata::Transition& t) {
               return now_ >= (some_passed ? t.timing->upper : t.timing->lower);
             });
    }
    const auto certain = [&](const automata::Transition& t) { return now_ >= t.timing->upper; };
    const bool some_certain = std::any_of(enabled_.timed.begin(), enabled_.timed.end(),
                                          [&](automata::TransitionId id) { return certain(transition(id)); });
    if (some_certain) return leads(enabled_.timed, to, certain);
    return from == to || leads(enabled_.timed, to, [&](const automata::Transition& t) {
             return before_ < t.timing->upper && t.timing->lower < now_;
           });
  }

  /// The same but for what exists at one instant only, in dense time: at its bound an exit is taken, and at its lower
  /// bound none is where that is the end of a cycle (`at_bound`).
  [[nodiscard]] bool allows_lastingly(automata::ModeId from, automata::ModeId to, bool at_bound) const {
    if (period_ || !enabled_.untimed.empty() || !allows_without_fault(from, to)) return allows_without_fault(from, to);
    const auto due = [&](const automata::Transition& t) { return now_ >= t.timing->upper; };
    const bool some_due = std::any_of(enabled_.timed.begin(), enabled_.timed.end(),
                                      [&](automata::TransitionId id) { return due(transition(id)); });
    if (some_due) return leads(enabled_.timed, to, due);
    return from == to || leads(enabled_.timed, to, [&](const automata::Transition& t) {
             const bool met = at_bound && automata::Ticks{0} < now_;
             return met ? t.timing->lower < now_ : t.timing->lower <= now_;
           });
  }
  /// In dense time: whether the component lets time pass at some reading of its clock.
  [[nodiscard]] bool may_rest(automata::ModeId mode) const {
    return std::all_of(enabled_.untimed.begin(), enabled_.untimed.end(),
                       [&](automata::TransitionId id) { return transition(id).to == mode; });
  }

  /// In dense time: whether time may have passed from the reading before up to this one in `mode`. Transitions to
  /// itself are staying.
  [[nodiscard]] bool allows_time(automata::ModeId mode) const {
    const auto stays = [&](automata::TransitionId id) { return transition(id).to == mode; };
    if (!std::any_of(enabled_.faults.begin(), enabled_.faults.end(), stays) && faults_are_certain()) return false;
    if (!enabled_.untimed.empty()) return std::all_of(enabled_.untimed.begin(), enabled_.untimed.end(), stays);
    return std::all_of(enabled_.timed.begin(), enabled_.timed.end(),
                       [&](automata::TransitionId id) { return stays(id) || now_ <= transition(id).timing->upper; });
  }

 private:
  /// At some reading on the way, its end left out: what is certain begins where it sets out, or at the lower bound of
  /// some fault.
  [[nodiscard]] bool faults_are_certain() const {
    const auto certain = [&](automata::Ticks reading) {
      return automata::nominal_share(component_, enabled_, reading, automata::Ticks{0}) == 0;
    };
    const auto begins = [&](automata::TransitionId id) {
      const automata::Transition& t = transition(id);
      return t.timing && before_ < t.timing->lower && t.timing->lower < now_ && certain(t.timing->lower);
    };
    // A clock that restarts reads 0 all the while.
    if (automata::restarts(component_, enabled_)) return certain(before_) || certain(automata::Ticks{0});
    return certain(before_) || std::any_of(enabled_.faults.begin(), enabled_.faults.end(), begins);
  }

  /// Whether a fault is within its bounds, if it has some.
  [[nodiscard]] bool is_due(const automata::Transition& fault) const {
    return !fault.timing || (fault.timing->lower <= now_ && now_ <= fault.timing->upper);
  }

  [[nodiscard]] const automata::Transition& transition(automata::TransitionId id) const {
    return component_.transitions[id.index()];
  }

  template <class Condition>
  [[nodiscard]] bool leads(const std::vector<automata::TransitionId>& transitions, automata::ModeId to,
                           const Condition& condition) const {
    return std::any_of(transitions.begin(), transitions.end(),
                       [&](automata::TransitionId id) { return transition(id).to == to && condition(transition(id)); });
  }

  const automata::Component& component_;
  const automata::Enabled& enabled_;
  automata::Ticks before_;
  automata::Ticks now_;
  std::optional<automata::Ticks> period_;
};

}  // namespace rmpl::verifier
