// The search for a goal state, as far as the goal needs it: which has plans, and which lasts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/reconfigure/goal.hpp"
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"
#include "runtime/reasoning/reconfigure/part_plans.hpp"
#include "runtime/reasoning/reconfigure/prospects.hpp"

namespace rmpl::runtime {

/// What the goal needs of a goal state, and the parts' plans for it.
struct Needed {
  std::vector<automata::ComponentId> components;
  automata::Modes target;  ///< the estimate, with those changes alone
  Permitted permitted;
  std::vector<bool> wanted;
  std::vector<Offer> offers;
};

/// From one estimate to one goal, which it does not entail. A state that an untimed transition takes away again is
/// passed over for one that lasts, where there is one that takes no more irreversible steps and moves no more
/// components that are not commandable: what it rests on is needed then, and comes first. Keeps references to all.
class Pursuit {
 public:
  /// So many failed plans are looked at, and so many states that do not last.
  static constexpr std::size_t failure_limit = 256;
  static constexpr std::size_t passing_limit = 32;

  Pursuit(automata::PlantStep& step, GoalInterpreter& interpreter, PartPlans& plans, const Parts& parts,
          const automata::Modes& modes, const Goal& goal, const Prospects& prospects)
      : step_(step),
        interpreter_(interpreter),
        plans_(plans),
        parts_(parts),
        modes_(modes),
        goal_(goal),
        prospects_(prospects) {}

  /// The goal state, for which `needed` has plans; else what is in the way of the best one.
  std::variant<automata::Modes, Impasse> run();
  [[nodiscard]] const Needed& needed() const { return needed_; }
  /// Where there is an impasse: the state that it is about, where it is about one.
  [[nodiscard]] std::optional<automata::Modes> refused() const { return refused_; }

 private:
  using Blamed = std::vector<automata::ComponentId>;
  /// A goal state that is lost as it is reached.
  struct Passing {
    automata::Modes state;
    Needed needed;
    std::pair<std::uint64_t, std::size_t> effort;
  };

  std::optional<Blamed> judge(const automata::Modes& candidate);
  void need(const automata::Modes& candidate);
  std::optional<std::pair<Impasse, std::size_t>> plan();
  std::optional<Blamed> undone_at_end();
  bool leaves_aside(const automata::Modes& candidate, const Blamed& undone);
  std::optional<Blamed> lost(const automata::Modes& candidate, Blamed blamed);
  Blamed blame(const automata::Modes& candidate, std::pair<Impasse, std::size_t> failed);
  void lay_ground();

  automata::PlantStep& step_;
  GoalInterpreter& interpreter_;
  PartPlans& plans_;
  const Parts& parts_;
  const automata::Modes& modes_;
  const Goal& goal_;
  const Prospects& prospects_;
  Needed needed_;
  std::size_t failures_ = 0;
  std::optional<Impasse> obstacle_;
  std::optional<automata::Modes> refused_;
  std::optional<Passing> passing_;  ///< the first that does not last: taken where no other does at no greater cost
  std::set<automata::ComponentId> rested_on_;
  std::size_t passed_ = 0;
  bool any_ = false;  ///< no more states that last are looked for
};

}  // namespace rmpl::runtime
