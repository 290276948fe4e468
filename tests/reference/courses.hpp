// Every state of a plant, every command in it and what may come of it nominally, written out: the ground of plans.hpp
// and executive.hpp. Exponential in the plant. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "automata/state.hpp"
#include "tests/reference/step.hpp"

namespace rmpl::reference {

/// States and actions have numbers. Works out what it is asked for, and remembers it. Keeps a reference to the step.
class Courses {
 public:
  explicit Courses(const Step& step);

  [[nodiscard]] const Step& step() const { return step_; }
  /// The possible ones, in lexicographic order.
  [[nodiscard]] const std::vector<automata::Modes>& states() const { return states_; }
  [[nodiscard]] const std::vector<automata::ControlAction>& actions() const { return actions_; }
  [[nodiscard]] std::size_t idle() const { return idle_; }
  [[nodiscard]] std::size_t number(const automata::Modes& modes) const { return numbers_.at(modes); }

  /// Whether the action agrees with the model.
  bool tolerates(std::size_t state, std::size_t action) { return known(state, action).tolerated; }
  /// What one step may lead to: timed exits may fire or not.
  const std::set<std::size_t>& after(std::size_t state, std::size_t action) { return known(state, action).after; }
  /// Of these, where one thing happens at a time: what needs no time, or else one timed transition.
  const std::set<std::size_t>& one_by_one(std::size_t state, std::size_t action) {
    return known(state, action).one_by_one;
  }
  /// What is sent where nothing is wanted: idle; where that contradicts the model, the first of the actions that do
  /// not, by: no mode is changed at once; fewest controls off idle. Idle where every action contradicts it.
  std::size_t rest(std::size_t state);
  /// What may come of wanting nothing, one thing after the other, the state itself among it.
  const std::set<std::size_t>& by_itself(std::size_t state);
  /// Whether something that may come so is enabled, and nothing but the interconnections excludes it: a dead end of the
  /// model, or nearly one.
  bool is_held_back(std::size_t state);
  /// Whether all controls can be idle, and what is enabled then can come.
  bool is_plain(std::size_t state) { return tolerates(state, idle_) && !is_held_back(state); }
  /// Whether idling is tolerated, and changes nothing.
  bool stays(std::size_t state) { return tolerates(state, idle_) && after(state, idle_) == std::set{state}; }
  /// Whether it takes all controls that are off idle to bring something about or to prevent it: two commands at once
  /// are not one. Where idling contradicts the model, it may take one that is off idle to keep all others where they
  /// are.
  bool is_one_command(std::size_t state, std::size_t action);
  /// The nominal transitions that the action enables, and that can be taken at all.
  const std::set<const automata::Transition*>& enabled(std::size_t state, std::size_t action) {
    return known(state, action).enabled;
  }

 private:
  struct Move {
    bool tolerated = false;
    std::set<const automata::Transition*> enabled;
    std::set<std::size_t> after;
    std::set<std::size_t> one_by_one;
  };
  const Move& known(std::size_t state, std::size_t action);
  bool others_rest(std::size_t state, std::size_t action);
  [[nodiscard]] bool is_one_by_one(const Move& move, const automata::Modes& from, const automata::Modes& to) const;

  const Step& step_;
  std::vector<automata::Modes> states_;
  std::map<automata::Modes, std::size_t> numbers_;
  std::vector<automata::ControlAction> actions_;
  std::size_t idle_ = 0;
  std::map<const automata::Transition*, std::size_t> component_of_;
  std::map<std::pair<std::size_t, std::size_t>, Move> moves_;
  std::map<std::size_t, std::size_t> rest_;
  std::map<std::size_t, std::set<std::size_t>> by_itself_;
};

}  // namespace rmpl::reference
