// Step_THCA of thesis Fig. 5-3, its ten steps one after the other over sets: the twin of automata/step/program_step.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "automata/program.hpp"
#include "tests/reference/models.hpp"

namespace rmpl::reference {

class Sequencer {
 public:
  /// Entailment by `models`: of the plant, or of the program's own variables. Keeps references to both.
  Sequencer(const automata::Program& program, const Models& models);

  [[nodiscard]] const std::set<automata::LocationId>& marking() const { return marking_; }

  /// Takes up a run elsewhere.
  void resume(std::set<automata::LocationId> marking, std::map<automata::ClockId, automata::Ticks> started) {
    marking_ = std::move(marking);
    started_ = std::move(started);
  }
  [[nodiscard]] const std::map<automata::ClockId, automata::Ticks>& started() const { return started_; }

  struct Goal {
    std::set<automata::Assignment> assignments;
    std::vector<automata::Formula> constraints;  ///< what else is asked, each once, in the order of the locations
    bool contradictory = false;                  ///< two different values for one variable
    [[nodiscard]] bool empty() const { return assignments.empty() && constraints.empty(); }
  };
  /// What the executive knows, of all that conditions ask: these atoms are so, all others are not.
  void know(std::vector<automata::Formula> atoms) { so_ = std::move(atoms); }
  /// Steps 1 to 4: the goals of the program, and, behind them in order, those of each branch of an `each`, which may be
  /// empty.
  std::vector<Goal> begin(const std::vector<automata::Assignment>& knowledge, automata::Ticks now);
  /// Steps 7 to 10.
  void finish(const std::vector<automata::Assignment>& knowledge);

  /// Readings of the active clocks as of the last `begin`.
  [[nodiscard]] const Clocks& clocks() const { return interpretation_; }

 private:
  using Locations = std::set<automata::LocationId>;

  [[nodiscard]] const automata::Location& at(automata::LocationId id) const { return program_.locations[id.index()]; }
  [[nodiscard]] bool satisfied(const automata::Condition& condition,
                               const std::vector<automata::Assignment>& knowledge) const;
  [[nodiscard]] bool achieved(automata::LocationId location, const std::vector<automata::Assignment>& knowledge) const;
  /// The formula with each atom of knowledge replaced by whether it is so.
  [[nodiscard]] automata::Formula known(const automata::Formula& formula) const;
  /// All locations inside a composite one, at any depth.
  [[nodiscard]] Locations subautomata(automata::LocationId composite) const;
  /// m_F: the location with its start locations, recursively.
  [[nodiscard]] Locations full_marking(automata::LocationId location) const;

  const automata::Program& program_;
  const Models& models_;
  Locations marking_;
  std::map<automata::ClockId, automata::Ticks> started_;       ///< t_init(i)
  std::map<automata::ClockId, automata::Ticks> started_next_;  ///< what this cycle adds
  Clocks interpretation_;                                      ///< omega(i)
  std::vector<automata::Formula> so_;
  Locations violated_;  ///< marked primitives whose own maintenance constraint is violated in this cycle
};

}  // namespace rmpl::reference
