// Mode reconfiguration: strategies, goals of single components where the game is too large, and why there is no plan.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

#include <unordered_map>
#include <utility>
#include <variant>

#include "base/hash.hpp"
#include "runtime/reasoning/game/strategist.hpp"
#include "runtime/reasoning/nominal/idling.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"
#include "runtime/reasoning/reconfigure/impasse.hpp"
#include "runtime/reasoning/reconfigure/reachable_modes.hpp"
#include "runtime/reasoning/reconfigure/recent_goals.hpp"
#include "runtime/reasoning/reconfigure/strategy_answer.hpp"
#include "runtime/reasoning/reconfigure/subgoals.hpp"

namespace rmpl::runtime {

using automata::Formula;
using automata::Modes;

namespace {

/// Beyond this many states of one goal its answers are forgotten: long runs stay flat.
constexpr std::size_t answer_limit = 1u << 14;

class StrategyReconfigurer : public Reconfigurer {
 public:
  StrategyReconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph, automata::Ticks cycle)
      : step_(step),
        cycle_(cycle),
        graph_(std::move(graph)),
        common_(std::make_shared<PlantGames>(step, *graph_)),
        interpreter_(step, *graph_),
        goals_(step) {}

  Reconfiguration next(const Modes& modes, const Formula& goal) override { return go_on(modes, goal, {}); }

  Reconfiguration go_on(const Modes& modes, const Formula& goal, const StrategyPosition& position) override {
    if (goal.is_true()) return at_rest(step_, modes);
    Asked& asked = goals_.find(goal);
    auto& decided = asked.memory.decided;
    InForce key(modes, position);
    if (const auto known = decided.find(key); known != decided.end()) return known->second;
    if (decided.size() >= answer_limit) decided.clear();
    return decided.emplace(std::move(key), decide(modes, position, asked)).first->second;
  }

 private:
  using InForce = std::pair<Modes, StrategyPosition>;
  struct InForceHash {
    std::size_t operator()(const InForce& key) const noexcept {
      return base::mix(automata::ModesHash()(key.first), key.second.hash());
    }
  };
  struct Memory {
    std::unique_ptr<Strategist> strategist;  ///< once it was asked for
    std::unordered_map<InForce, Reconfiguration, InForceHash> decided;
  };
  using Asked = RecentGoals<Memory>::Entry;

  Reconfiguration decide(const Modes& modes, const StrategyPosition& position, Asked& asked) {
    if (!step_.possible(modes)) {
      Impasse impossible{std::nullopt, "the estimated modes contradict each other"};
      return no_plan(step_, modes, std::move(impossible));
    }
    auto& strategist = asked.memory.strategist;
    if (!strategist)
      strategist = std::make_unique<Strategist>(step_, *graph_, asked.goal.formula(), cycle_,
                                                Strategist::Relevant::upstream, Strategist::Least::large, common_);
    if (auto answer = strategy_answer(step_, *graph_, *strategist, modes, position)) {
      if (answer->why.obstacle != Reason::Obstacle::not_found) return *std::move(answer);
      auto impasse = bars(modes, asked.goal);
      return impasse ? no_plan(step_, modes, *std::move(impasse)) : *std::move(answer);
    }
    if (!subgoals_) subgoals_.emplace(step_, *graph_, common_);
    return subgoals_->next(modes, asked.goal);
  }

  /// What the model or the goal lacks: of one part of the goal by itself where there is such a part. Nothing where each
  /// component can come, by itself, to where the goal holds.
  std::optional<Impasse> bars(const Modes& modes, const Goal& goal) {
    const std::vector<Formula> parts = conjuncts_of(goal.formula());
    std::optional<std::uint32_t> open;  // the first
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      const Goal alone(parts[i], step_.plant(), step_.theory());
      if (interpreter_.entailed(modes, alone)) continue;
      if (!open) open = i;
      if (parts.size() == 1) break;
      auto impasse = interpreted(modes, alone);
      if (!impasse || licenses(goal, impasse->why)) continue;
      impasse->why.conjunct = i;
      return impasse;
    }
    auto impasse = interpreted(modes, goal);
    if (impasse) impasse->why.conjunct = open;
    return impasse;
  }

  std::optional<Impasse> interpreted(const Modes& modes, const Goal& goal) {
    auto result = interpreter_.interpret(modes, goal, ReachableModes(*graph_, modes, goal));
    auto* impasse = std::get_if<Impasse>(&result);
    if (impasse == nullptr) return std::nullopt;
    impasse->why.purpose = Reason::Purpose::goal;
    return std::move(*impasse);
  }

  /// Whether what bars the way is a step that the whole goal licenses: it bars the way to a part of the goal alone.
  [[nodiscard]] bool licenses(const Goal& goal, const Reason& why) const {
    if (why.obstacle != Reason::Obstacle::forbidden || !why.step) return false;
    const automata::Transition& t = step_.plant()[why.step->component].transitions[why.step->transition.index()];
    return graph_->leads_to_named(why.step->component, t.to, goal.named());
  }

  automata::PlantStep& step_;
  automata::Ticks cycle_;
  std::shared_ptr<const NominalGraph> graph_;
  std::shared_ptr<PlantGames> common_;
  GoalInterpreter interpreter_;
  RecentGoals<Memory> goals_;
  std::optional<Subgoals> subgoals_;  ///< once they were asked for
};

}  // namespace

Reconfiguration at_rest(automata::PlantStep& step, const Modes& modes) {
  Reconfiguration result;
  result.action = resting_action(step, modes);
  if (result.action == idle_action(step.plant())) return result;
  result.outcome = Reconfiguration::Outcome::command;
  result.expected = modes;
  result.why.purpose = Reason::Purpose::model;
  return result;
}

std::unique_ptr<Reconfigurer> make_reconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph,
                                                automata::Ticks cycle) {
  if (!graph) graph = reconfiguration_graph(step.plant());
  return std::make_unique<StrategyReconfigurer>(step, std::move(graph), cycle);
}

std::shared_ptr<const NominalGraph> reconfiguration_graph(const automata::Plant& plant) {
  return std::make_shared<NominalGraph>(plant);
}

}  // namespace rmpl::runtime
