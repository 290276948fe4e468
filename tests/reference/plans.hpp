// A planner of its own, which looks at every state: how soon a goal can be reached at all (semantics 5).
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automata/logic/formula.hpp"
#include "tests/reference/courses.hpp"

namespace rmpl::reference {

/// What one goal allows of one plant. Exponential in the plant. Keeps a reference to the courses.
class Plans {
 public:
  Plans(Courses& courses, const automata::Formula& goal);

  /// Whether the state entails the goal.
  [[nodiscard]] bool is_met(std::size_t state) const { return met_[state]; }

  /// Whether any state does.
  [[nodiscard]] bool is_possible() const { return std::find(met_.begin(), met_.end(), true) != met_.end(); }

  /// Whether the executive may send the action: it agrees with the model, takes no forbidden step, and need not lead to
  /// where one may come by itself that would not come anyway. Where idling contradicts the model, or only the
  /// interconnections keep back what would come, that is not asked.
  bool permits(std::size_t state, std::size_t action);

  /// Whether it is permitted, and one command, or what is sent where nothing is wanted.
  bool is_choice(std::size_t state, std::size_t action);

  /// The fewest cycles to a state that entails the goal by permitted commands, if all goes as it is hoped for. Nothing
  /// where there is no such way at all.
  std::optional<std::size_t> hoped(std::size_t state);

  /// The same where a command may lead to where a forbidden step comes by itself.
  std::optional<std::size_t> boldly(std::size_t state);

  /// The same as `hoped` by one control off idle a cycle, no forbidden step taken or left to time alone, where one
  /// thing happens at a time: what needs no time, or else one timed transition. Such a way is one by any reading of
  /// semantics 5.
  std::optional<std::size_t> soberly(std::size_t state);

  /// The same to a state that stays besides.
  std::optional<std::size_t> surely(std::size_t state);

 private:
  /// By component, the modes that they lead to.
  using Steps = std::set<std::pair<std::size_t, automata::ModeId>>;
  using Distances = std::vector<std::optional<std::size_t>>;

  /// The forbidden steps that the action may take.
  Steps taken(std::size_t state, std::size_t action);
  /// Those that may come by themselves.
  const Steps& coming(std::size_t state);
  bool leaves_to_chance(std::size_t state, std::size_t action);
  std::set<std::size_t> sober_outcomes(std::size_t state, std::size_t action);
  template <class Goals, class Outcomes>
  Distances distances(const Goals& goals, const Outcomes& outcomes);

  Courses& courses_;
  std::vector<bool> met_;                                                       ///< by state
  std::vector<std::pair<std::size_t, const automata::Transition*>> forbidden_;  ///< by component
  std::map<std::size_t, Steps> coming_;
  std::optional<Distances> hoped_;
  std::optional<Distances> boldly_;
  std::optional<Distances> soberly_;
  std::optional<Distances> surely_;
};

/// Whether time alone takes away no mode that the goal names.
bool lasts(const automata::Plant& plant, const automata::Formula& goal);

}  // namespace rmpl::reference
