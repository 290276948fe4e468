// Mode reconfiguration: the goal interpreter and the planner together, with a memory of their answers.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/reconfigurer.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <variant>

#include "runtime/reasoning/reconfigure/course.hpp"
#include "runtime/reasoning/reconfigure/drift.hpp"
#include "runtime/reasoning/reconfigure/goal_interpreter.hpp"
#include "runtime/reasoning/reconfigure/idling.hpp"
#include "runtime/reasoning/reconfigure/lasting.hpp"
#include "runtime/reasoning/reconfigure/nominal_graph.hpp"
#include "runtime/reasoning/reconfigure/part_plans.hpp"
#include "runtime/reasoning/reconfigure/parts.hpp"
#include "runtime/reasoning/reconfigure/planner.hpp"
#include "runtime/reasoning/reconfigure/prospects.hpp"
#include "runtime/reasoning/reconfigure/pursuit.hpp"
#include "runtime/reasoning/reconfigure/recent_goals.hpp"
#include "runtime/reasoning/reconfigure/settle.hpp"
#include "runtime/reasoning/reconfigure/telling.hpp"
#include "runtime/reasoning/reconfigure/upkeep.hpp"

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
  answer.why = impasse.why;
  return answer;
}

class PolicyReconfigurer : public Reconfigurer {
 public:
  PolicyReconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph, std::size_t trials)
      : step_(step),
        trials_(trials),
        graph_(std::move(graph)),
        parts_(step.plant(), graph_->restless()),
        interpreter_(step, *graph_),
        planner_(step, *graph_, parts_),
        plans_(planner_, parts_),
        goals_(step),
        course_(step, *graph_, parts_),
        tell_(step) {}

  Reconfiguration next(const Modes& modes, const Formula& goal) override {
    if (goal.is_true()) return at_rest(step_, modes);
    Asked& asked = goals_.find(goal);
    checked_ = 0;
    Reconfiguration answer = settled(modes, asked);
    answer.checked = checked_;
    return answer;
  }

 private:
  struct Memory {
    /// Of what housekeeping keeps: the goal, by how soon its parts may be lost by themselves as it begins.
    std::map<std::vector<Upkeep::Soon>, std::uint64_t> numbers;
    std::optional<Upkeep> upkeep;  ///< once it was asked for
    Answers answers;
    std::unordered_map<Modes, Modes, automata::ModesHash> aims;  ///< by where what is needed ends
  };
  using Asked = RecentGoals<Memory>::Entry;

  /// Failed plans after which those for rewards are told apart no more.
  static constexpr std::size_t exact_failures = 32;
  static constexpr std::size_t housekeeping_trials = 1u << 11;

  const Reconfiguration& settled(const Modes& modes, Asked& asked) {
    Answers& answers = asked.memory.answers;
    if (const auto known = answers.find(modes); known != answers.end())
      return weighed(modes, known->second, asked).answer;
    if (answers.size() >= answer_limit) answers.clear();
    return weighed(modes, asked).answer;
  }

  Answered& weighed(const Modes& modes, Asked& asked) {
    Answers& answers = asked.memory.answers;
    if (const auto known = answers.find(modes); known != answers.end()) return weighed(modes, known->second, asked);
    settle(modes, course_, answers, [&](const Modes& state, For reward) { return answer(state, asked, reward); });
    return weighed(modes, answers.at(modes), asked);
  }

  Answered& weighed(const Modes& modes, Answered& answered, Asked& asked) {
    if (std::exchange(answered.weighed, true)) return answered;
    const bool begins = answered.answer.outcome == Reconfiguration::Outcome::command &&
                        answered.answer.why.purpose == Reason::Purpose::reward;
    if (begins && interpreter_.entailed(modes, asked.goal) &&
        worth_less_at_rest(modes, *answered.answer.expected, asked))
      answered = {For::nothing, answer(modes, asked, For::nothing), true};
    return answered;
  }

  /// Whether what is done for reward from the next state on comes to rest, with no time passing, where all modes
  /// together are worth less: some of it was not gone on with. Follows so many steps.
  bool worth_less_at_rest(const Modes& modes, Modes next, Asked& asked) {
    constexpr int most_steps = 64;
    for (int step = 0; step < most_steps; ++step) {
      const Reconfiguration& then = weighed(next, asked).answer;
      if (then.outcome == Reconfiguration::Outcome::nothing_to_do) return worth(next) < worth(modes);
      if (then.outcome != Reconfiguration::Outcome::command || then.why.purpose != Reason::Purpose::reward)
        return false;
      next = *then.expected;
    }
    return false;
  }

  [[nodiscard]] std::int64_t worth(const Modes& modes) const {
    std::int64_t sum = 0;
    for (std::size_t c = 0; c < modes.size(); ++c) sum += interpreter_.rewards()[c][modes[c].index()];
    return sum;
  }

  Reconfiguration answer(const Modes& modes, Asked& asked, For reward) {
    Reconfiguration result;
    if (!step_.possible(modes)) {
      result = refusal({std::nullopt, "the estimated modes contradict each other"}, {});
    } else if (interpreter_.entailed(modes, asked.goal)) {
      result = reward == For::nothing ? achieved(modes) : housekeeping(modes, asked, reward);
    } else {
      result = towards(modes, asked, reward);
    }
    if (result.outcome == Reconfiguration::Outcome::no_plan) result.action = resting_action(step_, modes);
    return result;
  }

  Reconfiguration achieved(const Modes& modes) {
    Reconfiguration result = at_rest(step_, modes);
    result.goal_state = modes;
    return result;
  }

  /// First what the goal needs.
  Reconfiguration towards(const Modes& modes, Asked& asked, For reward) {
    const Goal& goal = asked.goal;
    const Prospects prospects(*graph_, modes, goal, false);
    Pursuit pursuit(step_, interpreter_, plans_, parts_, modes, goal, prospects);
    auto interpreted = result_of(pursuit);
    if (auto* impasse = std::get_if<Impasse>(&interpreted)) {
      Impasse barred = std::move(*impasse);
      barred.why.conjunct = tell_.open_conjunct(modes, goal, barred.serves ? barred.serves : barred.component);
      barred.why.purpose = Reason::Purpose::goal;
      auto alone = barred_alone(modes, goal);
      return alone ? std::move(*alone) : refusal(std::move(barred), pursuit.refused());
    }
    const Needed& needed = pursuit.needed();
    const PlannedStep& step = PartPlans::best(needed.offers);
    Reconfiguration result;
    const bool waits = step.idle && reward != For::nothing;
    if (auto aside =
            waits ? beside(modes, std::get<Modes>(interpreted), needed, prospects, asked, reward) : std::nullopt) {
      result = tell_.step(modes, *aside, std::get<Modes>(interpreted), goal, Reason::Purpose::reward);
    } else {
      result = tell_.step(modes, step, needed.target, goal, Reason::Purpose::goal);
    }
    result.goal_state = aim(modes, needed, asked);
    if (!result.goal_state) result.goal_state = std::get<Modes>(std::move(interpreted));
    return result;
  }

  /// With the whole budget.
  std::variant<Modes, Impasse> result_of(Pursuit& pursuit) {
    planner_.renew_budget(trials_);
    auto result = pursuit.run();
    checked_ += interpreter_.checked();
    return result;
  }

  /// The answer to the first conjunct that has no plan by itself; nothing where each has one.
  std::optional<Reconfiguration> barred_alone(const Modes& modes, const Goal& goal) {
    const std::vector<Formula> conjuncts = conjuncts_of(goal.formula());
    const auto now = assignments_of(step_.plant(), modes);
    for (std::uint32_t i = 0; i < conjuncts.size() && conjuncts.size() > 1; ++i) {
      if (step_.theory().entails(now, step_.theory().encode(conjuncts[i]))) continue;
      const Goal alone(conjuncts[i], step_.plant(), step_.theory());
      const Prospects prospects(*graph_, modes, alone, false);
      Pursuit pursuit(step_, interpreter_, plans_, parts_, modes, alone, prospects);
      auto interpreted = result_of(pursuit);
      if (auto* impasse = std::get_if<Impasse>(&interpreted)) {
        impasse->why.purpose = Reason::Purpose::goal;
        impasse->why.conjunct = i;
        return refusal(std::move(*impasse), pursuit.refused());
      }
    }
    return std::nullopt;
  }

  /// What housekeeping aims at where the plan for what is needed ends; nothing where the goal is not entailed there.
  std::optional<Modes> aim(const Modes& modes, const Needed& needed, Asked& asked) {
    Modes end = plans_.end_of(modes, needed.offers);
    auto& aims = asked.memory.aims;
    if (const auto known = aims.find(end); known != aims.end()) return known->second;
    if (!interpreter_.entailed(end, asked.goal) || !step_.possible(end)) return std::nullopt;
    if (aims.size() >= answer_limit) aims.clear();
    const std::size_t checked = checked_;
    const Reconfiguration rest = housekeeping(end, asked, For::rewards);
    checked_ = checked;
    return aims.emplace(std::move(end), *rest.goal_state).first->second;
  }

  /// While what is needed waits, a command for components that are no part of the way, which is worth more whatever
  /// follows at once, or a repair of one: nothing is served by leaving a fault while time passes.
  std::optional<PlannedStep> beside(const Modes& modes, const Modes& target, const Needed& needed,
                                    const Prospects& prospects, Asked& asked, For reward) {
    Upkeep& upkeep = upkeep_of(asked);
    const Upkeep::Standing standing = upkeep.standing(modes);
    const auto followed = planner_.followed(modes, {needed.target, needed.permitted, 0, needed.wanted});
    std::vector<bool> way = followed.relied;
    for (std::size_t c = 0; c < way.size(); ++c) way[c] = way[c] || followed.moved[c];
    const Reached at_once = drift_from(*graph_, modes, Drift::untimed);
    const std::vector<bool> carried = relied_on_under_way(modes, target, prospects);
    for (const ComponentId c : planner_.order()) {
      const bool broken = step_.plant()[c].modes[modes[c.index()].index()].fault;
      if ((way[c.index()] && !broken) || target[c.index()] == modes[c.index()]) continue;
      // What the goal would have to undo again is not done.
      if (!broken && !left_by_itself(target, c, step_).empty()) continue;
      if (!broken && carried[c.index()]) continue;
      Modes aim = modes;
      aim[c.index()] = target[c.index()];
      std::vector<bool> wanted(modes.size());
      wanted[c.index()] = true;
      std::vector<bool> resting = way;
      resting[c.index()] = false;
      const auto others_rest = [&](const Modes& after) {
        for (std::size_t i = 0; i < after.size(); ++i) {
          if (resting[i] && after[i] != modes[i]) return false;
        }
        return upkeep.leaves(resting, standing, after, needed.target) && upkeep.keeps(standing, after);
      };
      const Permitted permitted = prospects.permitted(aim);
      planner_.renew_budget(std::min(trials_, housekeeping_trials));
      auto found = planner_.next(modes, {aim, permitted, parts_.of(c), wanted, others_rest, wanted, std::nullopt});
      auto* const plan = std::get_if<IslandPlan>(&found);
      if (plan == nullptr || plan->first.idle) continue;
      const bool pays =
          worth_more(parts_.of(c), at_once, drift_from(*graph_, plan->end, Drift::untimed)) &&
          (reward == For::rewards || worth_more(parts_.of(c), prospects.drift(), drift_from(*graph_, plan->end)));
      if (broken || pays) return std::move(plan->first);
    }
    return std::nullopt;
  }

  /// What others rely on that time takes to the modes that are aimed at for them.
  std::vector<bool> relied_on_under_way(const Modes& modes, const Modes& target, const Prospects& prospects) {
    std::vector<bool> result(modes.size());
    const Permitted permitted = prospects.permitted(target);
    for (const ComponentId c : planner_.order()) {
      if (target[c.index()] == modes[c.index()]) continue;
      std::vector<bool> wanted(modes.size());
      wanted[c.index()] = true;
      const Objective objective{target, permitted, parts_.of(c), wanted};
      if (!planner_.is_under_way(modes, objective, c)) continue;
      const std::vector<bool> relied = planner_.followed(modes, objective).relied;
      for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] || (relied[i] && ComponentId(i) != c);
    }
    return result;
  }

  /// Then housekeeping: what is worth more, under which the goal stays entailed.
  Reconfiguration housekeeping(const Modes& modes, Asked& asked, For reward) {
    const Goal& goal = asked.goal;
    Upkeep& upkeep = upkeep_of(asked);
    const Upkeep::Standing standing = upkeep.standing(modes);
    std::uint64_t& known = asked.memory.numbers[standing.loss];
    if (known == 0) known = ++numbers_;
    const auto number = goal.rest() ? std::nullopt : std::optional(known);
    const Prospects prospects(*graph_, modes, goal, true);
    planner_.renew_budget(std::min(trials_, housekeeping_trials));
    std::size_t failures = 0;
    std::unordered_map<Modes, bool, automata::ModesHash> kept;  // one plan after the other asks of the same states
    const auto keeps = [&](const Modes& after) {
      const auto [at, fresh] = kept.try_emplace(after);
      if (fresh) at->second = upkeep.keeps(standing, after);
      return at->second;
    };
    std::vector<bool> moved(modes.size());
    const auto plan_for = [&](const Modes& candidate, std::vector<Offer>& offers) {
      std::vector<bool> wanted(modes.size());
      for (std::size_t c = 0; c < modes.size(); ++c) {
        moved[c] = candidate[c] != modes[c];
        wanted[c] = moved[c] || prospects.commandable(ComponentId(c));
      }
      const Permitted permitted = prospects.permitted(candidate);
      offers.clear();
      return plans_.plan(modes, {candidate, permitted, 0, wanted, keeps, moved, number}, offers);
    };
    std::vector<Offer> offers;
    auto interpreted = interpreter_.interpret(
        modes, goal, prospects, [&](const Modes& candidate) -> std::optional<std::vector<ComponentId>> {
          for (std::size_t c = 0; c < modes.size(); ++c) {
            if (candidate[c] == modes[c] || goal.named()[c][candidate[c].index()]) continue;
            if (auto blamed = left_by_itself(candidate, ComponentId(c), step_); !blamed.empty()) return blamed;
          }
          const auto failed = plan_for(candidate, offers);
          if (!failed && reward == For::rewards) return std::nullopt;
          auto lost = failed ? std::nullopt : worth_no_more(prospects.drift(), plans_.end_of(modes, offers), offers);
          if (!failed && !lost) return std::nullopt;
          std::vector<ComponentId> blamed;
          if (++failures >= Pursuit::failure_limit) return blamed;
          if (lost) return lost;
          for (const ComponentId c : parts_.components(failed->second)) {
            if (failures < exact_failures || candidate[c.index()] != modes[c.index()]) blamed.push_back(c);
          }
          return blamed;
        });
    checked_ += interpreter_.checked();
    if (std::holds_alternative<Impasse>(interpreted) || offers.empty()) return achieved(modes);
    const Modes& target = std::get<Modes>(interpreted);
    const Modes end = plans_.end_of(modes, offers);
    // What the rest comes to stay upon comes first, where it has a plan by itself: a supply before its load.
    std::vector<Offer> ground;
    if (const auto first = rested_on(modes, end, step_); first && !plan_for(*first, ground)) offers = std::move(ground);
    Reconfiguration result = tell_.step(modes, PartPlans::best(offers), target, goal, Reason::Purpose::reward);
    result.goal_state = end;
    return result;
  }

  /// The components of a part that is not worth more where its plan ends than it is now: what is gained is lost again
  /// by itself, there or elsewhere. Nothing where each part is.
  std::optional<std::vector<ComponentId>> worth_no_more(const Reached& now, const Modes& end,
                                                        const std::vector<Offer>& offers) {
    const Reached then = drift_from(*graph_, end);
    for (const Offer& offer : offers) {
      if (!worth_more(offer.part, now, then)) return parts_.components(offer.part);
    }
    return std::nullopt;
  }

  bool worth_more(std::size_t part, const Reached& before, const Reached& after) {
    const std::vector<ComponentId>& components = parts_.components(part);
    return lasting_reward(interpreter_.rewards(), after, components) >
           lasting_reward(interpreter_.rewards(), before, components);
  }

  Upkeep& upkeep_of(Asked& asked) {
    if (!asked.memory.upkeep) asked.memory.upkeep.emplace(step_, *graph_, asked.goal);
    return *asked.memory.upkeep;
  }

  automata::PlantStep& step_;
  std::size_t trials_;
  std::shared_ptr<const NominalGraph> graph_;
  Parts parts_;
  GoalInterpreter interpreter_;
  Planner planner_;
  PartPlans plans_;
  RecentGoals<Memory> goals_;
  Course course_;
  Telling tell_;
  std::uint64_t numbers_ = 0;  ///< given so far
  std::size_t checked_ = 0;
};

}  // namespace

std::unique_ptr<Reconfigurer> make_reconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph,
                                                std::size_t trials) {
  if (!graph) graph = reconfiguration_graph(step.plant());
  return std::make_unique<PolicyReconfigurer>(step, std::move(graph), trials);
}

std::shared_ptr<const NominalGraph> reconfiguration_graph(const automata::Plant& plant) {
  return std::make_shared<NominalGraph>(plant);
}

}  // namespace rmpl::runtime
