// One-step reconfiguration, by conflict-directed search over the control variables.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/one_step.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "base/check.hpp"
#include "base/product.hpp"
#include "runtime/reasoning/nominal/idling.hpp"
#include "runtime/reasoning/nominal/nominal_graph.hpp"
#include "runtime/reasoning/nominal/precondition_finder.hpp"
#include "runtime/reasoning/ocsp/ocsp.hpp"
#include "runtime/reasoning/reconfigure/recent_goals.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::Formula;
using automata::ModeId;
using automata::Modes;
using automata::Plant;
using automata::TransitionId;
using automata::ValueId;

namespace {

/// Candidates that one answer may take: all pairs of commands of half a hundred controls.
constexpr std::size_t candidate_limit = 1u << 12;

bool contains(const std::vector<TransitionId>& ids, TransitionId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

class OneStepReconfigurer final : public Reconfigurer {
 public:
  OneStepReconfigurer(automata::PlantStep& step, std::shared_ptr<const NominalGraph> graph)
      : step_(step),
        plant_(step.plant()),
        idle_(idle_action(plant_)),
        graph_(std::move(graph)),
        control_of_(plant_.variables.size(), none),
        goals_(step) {
    for (std::size_t i = 0; i < plant_.controls.size(); ++i) control_of_[plant_.controls[i].variable.index()] = i;
    for (std::size_t i = 0; i < idle_.size(); ++i) {
      auto& cost = costs_.emplace_back(plant_.variables[plant_.controls[i].variable].values.size(), 1.0);
      cost[idle_[i].index()] = 0;
    }
  }

  Reconfiguration next(const Modes& modes, const Formula& goal) override {
    return next_of_all(std::span(&modes, 1), goal, {});
  }
  [[nodiscard]] bool looks_at_all() const override { return true; }

  Reconfiguration next_of_all(std::span<const Modes> tracked, const Formula& formula,
                              const StrategyPosition& /*position*/) override {
    if (formula.is_true()) return at_rest(step_, tracked.front());
    Reconfiguration answer;
    answer.action = resting_action(step_, tracked.front());
    const Goal& goal = goals_.find(formula).goal;
    Found found = search(tracked, goal, Scope::permitted);
    answer.checked = found.checked;
    switch (found.outcome) {
      case OptimalSearch::Outcome::solution:
        CHECK(found.expected && "a feasible action leads somewhere");
        return describe(std::move(answer), found.action, tracked.front(), std::move(*found.expected));
      case OptimalSearch::Outcome::exhausted:
        return impossible(std::move(answer), tracked, goal);
      case OptimalSearch::Outcome::budget: {
        const std::string among = std::to_string(answer.checked);
        return refusal(std::move(answer),
                       "no control action that achieves the goal in one step was found among " + among);
      }
    }
    return answer;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  static Reconfiguration refusal(Reconfiguration answer, std::string reason) {
    answer.outcome = Reconfiguration::Outcome::no_plan;
    answer.reason = std::move(reason);
    return answer;
  }

  /// Which actions are looked at: those that may be taken; or those, too, that do what cannot be undone.
  enum class Scope { permitted, all };
  struct Found {
    OptimalSearch::Outcome outcome;
    ControlAction action;           ///< with a solution
    std::optional<Modes> expected;  ///< likewise: what it leads the most likely state to
    std::size_t checked;
  };

  Found search(std::span<const Modes> tracked, const Goal& goal, Scope scope) {
    Found found{};
    const auto check = [&](std::span<const std::uint32_t> values) -> std::optional<Conflict> {
      found.action.clear();
      for (const std::uint32_t v : values) found.action.emplace_back(v);
      for (const Modes& modes : tracked) {
        std::optional<Modes> successor;
        if (auto conflict = refute(modes, found.action, goal, scope, successor)) return conflict;
        if (&modes == &tracked.front()) found.expected = std::move(successor);
      }
      return std::nullopt;
    };
    OptimalSearch search(costs_);
    search.set_budget(candidate_limit);
    found.outcome = search.next(check);
    found.checked = search.checked();
    return found;
  }

  /// Why no action is enough that may be taken: perhaps one is that may not.
  Reconfiguration impossible(Reconfiguration answer, std::span<const Modes> tracked, const Goal& goal) {
    const Found found = search(tracked, goal, Scope::all);
    answer.checked += found.checked;
    if (found.outcome == OptimalSearch::Outcome::solution) {
      for (const Modes& modes : tracked) {
        const automata::AllEnabled idle = step_.enabled(modes, idle_);
        const automata::AllEnabled enabled = step_.enabled(modes, found.action);
        for (std::size_t c = 0; c < modes.size(); ++c) {
          const NominalTransition* const t = forbidden(ComponentId(c), idle[c], enabled[c], goal);
          if (t == nullptr) continue;
          const automata::Component& component = plant_[*(answer.component = ComponentId(c))];
          return refusal(std::move(answer),
                         "no permitted control action achieves the goal in one step; the cheapest action takes '" +
                             component.name + "' to '" + component.modes[t->to.index()].name +
                             "', which is irreversible, and the goal does not name that mode");
        }
      }
    }
    return refusal(std::move(answer), "no control action achieves the goal in one step");
  }

  Reconfiguration describe(Reconfiguration answer, const ControlAction& action, const Modes& modes,
                           Modes expected) const {
    answer.action = action;
    answer.goal_state = expected;
    const auto moved = std::mismatch(modes.begin(), modes.end(), expected.begin()).first;
    if (answer.action == idle_ && moved == modes.end()) return answer;
    answer.outcome = answer.action == idle_ ? Reconfiguration::Outcome::wait : Reconfiguration::Outcome::command;
    if (moved != modes.end()) answer.component = ComponentId(static_cast<std::size_t>(moved - modes.begin()));
    for (std::size_t c = 0; c < modes.size() && answer.outcome == Reconfiguration::Outcome::command; ++c) {
      const auto& transitions = graph_->transitions(ComponentId(c));
      answer.irreversible =
          answer.irreversible || std::any_of(transitions.begin(), transitions.end(), [&](const NominalTransition& t) {
            return t.from == modes[c] && t.to == expected[c] && t.from != t.to && !t.reversible;
          });
    }
    answer.expected = std::move(expected);
    return answer;
  }

  /// The decisions of an action on the controls that the transitions out of a mode can feel: whatever agrees on them
  /// enables the same.
  Conflict felt(ComponentId component, ModeId from, std::optional<TransitionId> only,
                const ControlAction& action) const {
    std::set<std::size_t> controls;
    for (const NominalTransition& t : graph_->transitions(component)) {
      if (t.from != from || (only && t.id != *only)) continue;
      if (t.preconditions.size() >= PreconditionFinder::limit) return whole(action);
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          if (control_of_[r.variable.index()] != none) controls.insert(control_of_[r.variable.index()]);
        }
      }
    }
    Conflict conflict;
    for (const std::size_t i : controls) {
      conflict.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(action[i].index())});
    }
    return conflict;
  }
  static Conflict whole(const ControlAction& action) {
    Conflict conflict;
    for (std::uint32_t i = 0; i < action.size(); ++i) {
      conflict.push_back({i, static_cast<std::uint32_t>(action[i].index())});
    }
    return conflict;
  }

  /// Nothing where the action is feasible in this state, `successor` being what it leads to first; else a conflict.
  std::optional<Conflict> refute(const Modes& modes, const ControlAction& action, const Goal& goal, Scope scope,
                                 std::optional<Modes>& successor) {
    std::vector<Assignment> store = assignments_of(plant_, modes);
    const std::vector<Assignment> controls = assignments_of(plant_, action);
    store.insert(store.end(), controls.begin(), controls.end());
    if (!step_.theory().consistent(store)) {
      Conflict conflict;
      for (const Assignment& a : step_.theory().conflict()) {
        const std::size_t i = control_of_[a.variable.index()];
        if (i != none) conflict.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(a.value.index())});
      }
      std::sort(conflict.begin(), conflict.end(), [](const auto& a, const auto& b) { return a.variable < b.variable; });
      return conflict;
    }
    const automata::AllEnabled idle = step_.enabled(modes, idle_);
    const automata::AllEnabled enabled = step_.enabled(modes, action);
    std::vector<std::vector<ModeId>> choices;
    for (std::size_t c = 0; c < modes.size(); ++c) {
      const ComponentId id(c);
      if (scope == Scope::permitted) {
        const NominalTransition* const t = forbidden(id, idle[c], enabled[c], goal);
        if (t != nullptr) return felt(id, modes[c], t->id, action);
      }
      auto& targets = choices.emplace_back();
      const auto add = [&](ModeId mode) {
        if (std::find(targets.begin(), targets.end(), mode) == targets.end()) targets.push_back(mode);
      };
      const auto& transitions = plant_[id].transitions;
      for (const TransitionId t : enabled[c].untimed) add(transitions[t.index()].to);
      if (targets.empty()) {
        add(modes[c]);
        for (const TransitionId t : enabled[c].timed) add(transitions[t.index()].to);
      }
      const bool good = std::all_of(targets.begin(), targets.end(), [&](ModeId m) { return goal.permits(id, m); });
      if (!good) return felt(id, modes[c], std::nullopt, action);
    }
    return every_way(choices, goal, successor) && successor ? std::nullopt : std::optional(whole(action));
  }

  /// A step that cannot be undone, is none of those that the goal names, and is due to the action; or null.
  [[nodiscard]] const NominalTransition* forbidden(ComponentId component, const Enabled& idle, const Enabled& enabled,
                                                   const Goal& goal) const {
    for (const TransitionId id : enabled.untimed) {
      const NominalTransition* const t = graph_->find(component, id);
      if (t == nullptr || t->from == t->to || contains(idle.untimed, id)) continue;
      if (!NominalGraph::harmless(*t) && !graph_->leads_to_named(component, t->to, goal.named())) return t;
    }
    return nullptr;
  }

  /// Whether the goal, which permits each choice, is entailed in each possible combination of them. Where it asks for
  /// modes alone it is, and the first combination is enough.
  bool every_way(const std::vector<std::vector<ModeId>>& choices, const Goal& goal, std::optional<Modes>& first) {
    Modes next(choices.size());
    bool every = true;
    base::multiply_out(
        choices,
        [&](std::size_t c, std::size_t i) {
          next[c] = choices[c][i];
          return true;
        },
        [](std::size_t, std::size_t) {},
        [&] {
          if (!step_.possible(next)) return false;
          if (!first) first = next;
          every = !goal.rest() || step_.theory().entails(assignments_of(plant_, next), goal.rest()->holds);
          return !every || !goal.rest();
        });
    return every;
  }

  automata::PlantStep& step_;
  const Plant& plant_;
  ControlAction idle_;
  std::shared_ptr<const NominalGraph> graph_;
  std::vector<std::size_t> control_of_;  ///< by variable
  OptimalSearch::Costs costs_;
  struct Nothing {};
  RecentGoals<Nothing> goals_;
};

}  // namespace

std::unique_ptr<Reconfigurer> make_one_step_reconfigurer(automata::PlantStep& step,
                                                         std::shared_ptr<const NominalGraph> graph) {
  if (!graph) graph = reconfiguration_graph(step.plant());
  return std::make_unique<OneStepReconfigurer>(step, std::move(graph));
}

}  // namespace rmpl::runtime
