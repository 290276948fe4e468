// Mode reconfiguration: from an estimate and a configuration goal to the next command (semantics 5; thesis 6.3).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "automata/logic/formula.hpp"
#include "automata/state.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/reasoning/game/position.hpp"
#include "runtime/reasoning/reconfigure/reason.hpp"

namespace rmpl::runtime {

class NominalGraph;

/// What reconfiguration answers in one cycle.
struct Reconfiguration {
  enum class Outcome {
    command,        ///< issue `action`
    wait,           ///< stay idle: a timed transition will do the next thing
    nothing_to_do,  ///< the estimate is the goal state
    no_plan         ///< no reachable state entails the goal, or no commands lead there; `reason` says why
  };
  Outcome outcome = Outcome::nothing_to_do;
  automata::ControlAction action;                  ///< sent whatever the outcome; unless `command`, what is nearest
                                                   ///< to idle of what the model tolerates
  std::optional<automata::Modes> goal_state;       ///< chosen by the goal interpreter
  std::optional<automata::Modes> expected;         ///< with `command` and `wait`: the state after it if nothing fails
  std::optional<automata::ComponentId> component;  ///< with `no_plan`: the one to blame, where there is one;
                                                   ///< with `command` and `wait`: the one that is to change its mode
  std::string reason;                              ///< with `no_plan`: in words
  Reason why;                                      ///< as data; of what the commands and waits serve, too
  std::size_t checked = 0;                         ///< candidates checked for this answer
  bool irreversible = false;                       ///< the command leads where no nominal sequence leads back from
  bool sure = false;                               ///< by a strategy that comes to the goal on every run
  bool bounds_counted = false;                     ///< by strategies, wherever bounds of the model matter
  std::shared_ptr<const StrategyEdges> edges;      ///< what is known next; null: no more than modes tell
};

/// What is known when an answer has led to these modes.
inline StrategyPosition position_after(const Reconfiguration& answer, const automata::Modes& modes) {
  return answer.edges ? answer.edges->to(modes) : StrategyPosition();
}

/// A reconfigurer answers for one plant. Answers depend on the arguments alone.
class Reconfigurer {
 public:
  virtual ~Reconfigurer() = default;
  /// The first control action of a sequence from `modes` to the best reachable state that entails `goal` (over modes
  /// and attributes; no clock atoms). `true` as goal asks for nothing: the answer is `nothing_to_do`.
  virtual Reconfiguration next(const automata::Modes& modes, const automata::Formula& goal) = 0;
  /// The same, where strategies are in force.
  virtual Reconfiguration go_on(const automata::Modes& modes, const automata::Formula& goal,
                                const StrategyPosition& /*position*/) {
    return next(modes, goal);
  }
  /// The same, told all states that are tracked, at least one, the most likely first.
  virtual Reconfiguration next_of_all(std::span<const automata::Modes> tracked, const automata::Formula& goal,
                                      const StrategyPosition& position) {
    return go_on(tracked.front(), goal, position);
  }
  /// Whether the states after the first can matter.
  [[nodiscard]] virtual bool looks_at_all() const { return false; }
};

/// Nothing to do, but for what is nearest to idle where the model does not tolerate that.
Reconfiguration at_rest(automata::PlantStep& step, const automata::Modes& modes);

/// Decides by strategies (semantics 5); where the game of a part of the goal is too large by goals of single
/// components. Remembers its answers: a repeated question costs a look-up. Keeps a reference to `step`, and asks its
/// theory. `graph` is what was computed beforehand for the same plant, by `reconfiguration_graph`; without it that is
/// done here. `cycle`: of the executive, in which the bounds of the model count; 0 is dense time.
std::unique_ptr<Reconfigurer> make_reconfigurer(automata::PlantStep& step,
                                                std::shared_ptr<const NominalGraph> graph = nullptr,
                                                automata::Ticks cycle = {});

/// What reconfiguration computes before the first question, and most of its cost: several runs of one plant share it.
std::shared_ptr<const NominalGraph> reconfiguration_graph(const automata::Plant& plant);

}  // namespace rmpl::runtime
