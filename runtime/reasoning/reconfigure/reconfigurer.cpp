// Mode reconfiguration: the goal interpreter and the planner together, with a memory of their answers.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <variant>

#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"
#include "runtime/reasoning/reconfigure/islands.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/planner.hpp"
#include "runtime/reasoning/reconfigure/recent_goals.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Formula;
using automata::Modes;

namespace {

/// Beyond this many states of one goal its answers are forgotten: long runs stay flat.
constexpr std::size_t answer_limit = 1u << 14;

Reconfiguration refusal(Impasse impasse, std::optional<Modes> goal_state) {
  Reconfiguration answer;
  answer.outcome = Reconfiguration::Outcome::no_plan;
  answer.goal_state = std::move(goal_state);
  answer.component = impasse.component;
  answer.reason = std::move(impasse.reason);
  return answer;
}

class PolicyReconfigurer : public Reconfigurer {
 public:
  PolicyReconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph)
      : step_(step),
        idle_(idle_action(step.plant())),
        graph_(std::move(graph)),
        islands_(step.plant(), graph_->restless(step.plant())),
        interpreter_(step, *graph_),
        planner_(step, *graph_, islands_),
        goals_(step) {}

  Reconfiguration next(const Modes& modes, const Formula& goal) override {
    if (goal.is_true()) return idle(Reconfiguration::Outcome::nothing_to_do);
    auto& asked = goals_.find(goal);
    auto& answers = asked.memory.answers;
    if (const auto known = answers.find(modes); known != answers.end()) return known->second;
    if (answers.size() >= answer_limit) answers.clear();
    Reconfiguration fresh = answers.emplace(modes, answer(modes, asked)).first->second;
    fresh.checked = interpreter_.checked();
    return fresh;
  }

 private:
  struct Memory {
    std::optional<GoalInterpreter::Choice> chosen;
    std::unordered_map<Modes, Reconfiguration, automata::ModesHash> answers;
  };
  using Asked = RecentGoals<Memory>::Entry;

  [[nodiscard]] Reconfiguration idle(Reconfiguration::Outcome outcome) const {
    Reconfiguration answer;
    answer.outcome = outcome;
    answer.action = idle_;
    return answer;
  }

  Reconfiguration answer(const Modes& modes, Asked& asked) {
    Reconfiguration result = chosen(modes, asked);
    if (result.outcome == Reconfiguration::Outcome::no_plan) result.action = idle_;
    return result;
  }

  /// The next step of one island; whether it achieves what does not last, and whether the island has to be waited for.
  struct Offer {
    PlannedStep step;
    bool brief, waits;
  };

  /// The first command that need not be put off until another island has been waited for; else the first wait; else the
  /// first command.
  static std::size_t best(const std::vector<Offer>& offers) {
    const auto waiting = std::count_if(offers.begin(), offers.end(), [](const Offer& o) { return o.waits; });
    const auto rank = [&](const Offer& o) {
      if (o.step.idle) return 1;
      return o.brief && waiting > (o.waits ? 1 : 0) ? 2 : 0;
    };
    const auto at = std::min_element(offers.begin(), offers.end(),
                                     [&](const Offer& a, const Offer& b) { return rank(a) < rank(b); });
    return static_cast<std::size_t>(at - offers.begin());
  }

  /// Islands do not touch each other, so each is planned by itself; the first that has a command has its turn, in the
  /// order of goals, and the plant is waited for only where none has.
  Reconfiguration chosen(const Modes& modes, Asked& asked) {
    if (!step_.possible(modes)) return refusal({std::nullopt, "the estimated modes contradict each other"}, {});
    auto interpreted = interpreter_.interpret(modes, asked.goal, asked.memory.chosen);
    if (auto* impasse = std::get_if<Impasse>(&interpreted)) return refusal(std::move(*impasse), {});
    Modes target = std::get<Modes>(std::move(interpreted));

    std::vector<Offer> offers;
    std::vector<bool> planned(islands_.count());
    for (const ComponentId c : planner_.order()) {
      const std::size_t island = islands_.of(c);
      if (modes[c.index()] == target[c.index()] || planned[island]) continue;
      planned[island] = true;
      const Objective objective{target, asked.goal.named(), island};
      auto choice = planner_.next(modes, objective);
      if (auto* impasse = std::get_if<Impasse>(&choice)) return refusal(std::move(*impasse), std::move(target));
      auto& step = std::get<PlannedStep>(choice);
      const bool brief = planner_.is_brief(step, objective);
      offers.push_back({std::move(step), brief, planner_.has_waits(modes, objective)});
    }
    if (offers.empty()) {
      Reconfiguration result = idle(Reconfiguration::Outcome::nothing_to_do);
      result.goal_state = std::move(target);
      return result;
    }
    PlannedStep* const chosen = &offers[best(offers)].step;
    Reconfiguration result;
    result.outcome = chosen->idle ? Reconfiguration::Outcome::wait : Reconfiguration::Outcome::command;
    result.action = std::move(chosen->action);
    result.goal_state = std::move(target);
    result.expected = std::move(chosen->outcome.modes);
    result.component = chosen->component;
    result.why = reason_of(*chosen, *result.goal_state, asked.goal, modes);
    result.irreversible =
        !chosen->idle && std::any_of(chosen->outcome.moves.begin(), chosen->outcome.moves.end(),
                                     [](const NominalMove& move) { return !move.transition->reversible; });
    return result;
  }

  Reason reason_of(const PlannedStep& step, const Modes& target, const Goal& goal, const Modes& modes) {
    Reason reason;
    const std::vector<Formula> conjuncts = conjuncts_of(goal.formula());
    const auto now = assignments_of(step_.plant(), modes);
    reason.purpose = Reason::Purpose::reward;
    for (std::uint32_t i = 0; i < conjuncts.size() && reason.purpose == Reason::Purpose::reward; ++i) {
      if (step_.theory().entails(now, step_.theory().encode(conjuncts[i]))) continue;
      reason.purpose = Reason::Purpose::goal;
      reason.conjunct = i;
    }
    reason.component = step.component;
    reason.aim = target[step.component.index()];
    for (const NominalMove& move : step.outcome.moves) {
      if (move.component == step.component) reason.step = TransitionOf{move.component, move.transition->id};
    }
    return reason;
  }

  automata::PlantStep& step_;
  automata::ControlAction idle_;
  std::shared_ptr<const NominalGraph> graph_;
  Islands islands_;
  GoalInterpreter interpreter_;
  Planner planner_;
  RecentGoals<Memory> goals_;
};

}  // namespace

std::unique_ptr<Reconfigurer> make_reconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph) {
  if (!graph) graph = reconfiguration_graph(step.plant());
  return std::make_unique<PolicyReconfigurer>(step, std::move(graph));
}

std::shared_ptr<const NominalGraph> reconfiguration_graph(const automata::Plant& plant) {
  return std::make_shared<NominalGraph>(plant, Islands(plant));
}

}  // namespace rmpl::runtime
