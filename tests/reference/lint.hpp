// What lint claims of plants, by looking at all modes and commands: the twin of compiler/lint.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "tests/reference/models.hpp"

namespace rmpl::reference {

/// Keeps a reference to the plant. Cost: worlds times modes times commands, so for small plants only.
class PlantLint {
 public:
  using ModeSet = std::set<std::pair<std::size_t, std::size_t>>;        ///< component, mode
  using TransitionSet = std::set<std::pair<std::size_t, std::size_t>>;  ///< component, transition

  explicit PlantLint(const automata::Plant& plant);

  /// Modes that some state has.
  [[nodiscard]] const ModeSet& possible() const { return possible_; }
  /// Modes that some initial state has.
  [[nodiscard]] const ModeSet& initial() const { return initial_; }
  /// Modes that are reached where each component may at any time be in any mode that it has reached, or may enter.
  [[nodiscard]] const ModeSet& reached() const { return reached_; }
  /// Transitions from modes that are reached whose guards follow from some modes that are reached and some command.
  [[nodiscard]] const TransitionSet& enabled() const { return enabled_; }
  /// Modes that are reached, with each command that they are consistent with.
  [[nodiscard]] std::vector<std::pair<automata::Modes, automata::ControlAction>> situations() const;
  /// Whether some such modes and command imply both guards.
  [[nodiscard]] bool together(std::size_t component, std::size_t a, std::size_t b) const;
  /// Whether wherever the guard of the first is implied, that of one of the others is, too.
  [[nodiscard]] bool always_with(std::size_t component, std::size_t transition,
                                 const std::vector<std::size_t>& others) const;
  /// Whether some modes that are reached are consistent with a command.
  [[nodiscard]] bool allows(automata::Assignment command) const;
  /// Whether in all modes of the others that are reached, and under all commands, that leave both modes possible, the
  /// same observations are possible.
  [[nodiscard]] bool look_alike(std::size_t component, std::size_t a, std::size_t b) const;
  /// Whether there are such modes of the others, and such a command.
  [[nodiscard]] bool go_with_the_same(std::size_t component, std::size_t a, std::size_t b) const;
  /// Whether then the same guards of other components are implied.
  [[nodiscard]] bool mean_alike(std::size_t component, std::size_t a, std::size_t b) const;
  /// Whether a command has the effect of the idle value, on guards and on what is observed, in all modes.
  [[nodiscard]] bool is_idle(std::size_t control, automata::ValueId value) const;
  /// Whether, in all modes, what a component's nominal transitions wait for is the same under all commands.
  [[nodiscard]] bool is_independent(std::size_t component) const;

 private:
  [[nodiscard]] bool implied(std::size_t component, std::size_t transition, const automata::Modes& modes,
                             const automata::ControlAction& action) const;
  [[nodiscard]] bool consistent(const automata::Modes& modes, const automata::ControlAction& action) const;
  [[nodiscard]] bool possible(const automata::Modes& modes) const;
  [[nodiscard]] bool within(const automata::Modes& modes, const ModeSet& set, std::size_t but) const;
  [[nodiscard]] std::set<std::vector<automata::ValueId>> observations(const automata::Modes& modes,
                                                                      const automata::ControlAction& action,
                                                                      std::size_t without) const;
  [[nodiscard]] std::vector<bool> implied_by_others(std::size_t component, const automata::Modes& modes,
                                                    const automata::ControlAction& action) const;
  void find_starts();
  bool grow();
  /// `visit(modes, action)` for all consistent ones, the modes reached ones.
  template <class Visit>
  void for_each_situation(const Visit& visit) const;
  template <class Same>
  [[nodiscard]] bool same_in_both(std::size_t component, std::size_t a, std::size_t b, const Same& same) const;

  const automata::Plant& plant_;
  Models models_;
  std::vector<automata::Modes> modes_;            ///< all, possible or not
  std::vector<automata::ControlAction> actions_;  ///< all
  ModeSet possible_, initial_, reached_;
  TransitionSet enabled_;
};

}  // namespace rmpl::reference
