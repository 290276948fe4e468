// Waits, and what goes on meanwhile.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/plan_risks.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::TransitionId;

namespace {

/// Where untimed transitions of these components lead with all controls idle, one step after the other, each component
/// taking the first that is enabled: where they rest, or the model tolerates no more. Up to 16 steps.
automata::Modes rested(automata::Modes modes, const std::vector<ComponentId>& components, automata::PlantStep& step) {
  constexpr std::size_t most_steps = 16;
  const automata::ControlAction idle = idle_action(step.plant());
  for (std::size_t steps = 0; steps < most_steps && step.permits(modes, idle); ++steps) {
    automata::Modes next = modes;
    for (const ComponentId c : components) {
      const automata::Enabled& enabled = step.enabled(c, modes, idle);
      if (!enabled.untimed.empty()) next[c.index()] = step.plant()[c].transitions[enabled.untimed.front().index()].to;
    }
    if (next == modes || !step.possible(next)) break;
    modes = std::move(next);
  }
  return modes;
}

/// The transitions by which a component may have gone on in a step of the plan.
std::vector<const automata::Transition*> taken(const Plan& plan, std::size_t step, const automata::Component& component,
                                               std::size_t position) {
  std::vector<const automata::Transition*> result;
  const automata::ModeId from = plan.states[step][position];
  const automata::ModeId to = plan.states[step + 1][position];
  for (const automata::Transition& t : component.transitions) {
    if (from != to && t.from == from && t.to == to && !component.is_fault(t)) result.push_back(&t);
  }
  return result;
}

/// The components that take time in a step of the plan.
std::vector<ComponentId> waited_for(const Plan& plan, std::size_t step, const automata::Plant& plant) {
  std::vector<ComponentId> result;
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const auto ways = taken(plan, step, plant.components[c], c);
    if (std::any_of(ways.begin(), ways.end(), [](const automata::Transition* t) { return t->timing.has_value(); })) {
      result.emplace_back(c);
    }
  }
  return result;
}

/// From a step on: the components on whose modes it rests, and all that is still to come.
std::set<ComponentId> relied_on(const Plan& plan, std::size_t from, automata::PlantStep& step) {
  std::set<ComponentId> result;
  for (std::size_t i = from; i < plan.commands.size(); ++i) {
    for (std::size_t c = 0; c < step.plant().components.size(); ++c) {
      for (const automata::Transition* t : taken(plan, i, step.plant().components[c], c)) {
        if (t->guard.is_true()) continue;
        const auto& support = step.locality().support_of(t->guard).components;
        result.insert(support.begin(), support.end());
      }
    }
  }
  return result;
}

/// What leaves at once, by which something waited for has lost its ground before it can come: of each component the
/// first such transition.
std::vector<TransitionOf> lost_at_once(const Plan& plan, std::size_t at, automata::PlantStep& step,
                                       const std::vector<ComponentId>& waiting) {
  std::vector<TransitionOf> leaving;
  automata::Modes after = plan.states[at];
  for (std::size_t c = 0; c < after.size(); ++c) {
    const ComponentId component(c);
    for (const TransitionId id : step.enabled(component, plan.states[at], plan.commands[at]).untimed) {
      const automata::ModeId to = step.plant()[component].transitions[id.index()].to;
      if (to == after[c] || to != plan.states[at + 1][c]) continue;
      after[c] = to;
      leaving.push_back({component, id});
      break;
    }
  }
  const auto goes_on = [&](ComponentId c) {
    const auto& timed = step.enabled(c, after, plan.commands[at]).timed;
    return std::any_of(timed.begin(), timed.end(), [&](TransitionId id) {
      return step.plant()[c].transitions[id.index()].to == plan.states[at + 1][c.index()];
    });
  };
  if (leaving.empty() || !step.possible(after) || std::all_of(waiting.begin(), waiting.end(), goes_on)) return {};
  const std::set<ComponentId> relied = relied_on(plan, at, step);
  std::erase_if(leaving, [&](const TransitionOf& t) { return !relied.contains(t.component); });
  return leaving;
}

/// The plan carried on where something has happened meanwhile that it does not know of.
class Replay {
 public:
  Replay(const Plan& plan, automata::PlantStep& step, const automata::Formula& goal)
      : plan_(plan), step_(step), wanted_(step.theory().encode(goal)), concerned_(step.plant().components.size()) {
    const auto concern = [this](ComponentId c) {
      if (!concerned_[c.index()]) all_.push_back(c);
      concerned_[c.index()] = true;
    };
    for (const ComponentId c : step.locality().support_of(goal).components) concern(c);
    for (std::size_t i = 0; i < plan.commands.size(); ++i) {
      for (std::size_t c = 0; c < concerned_.size(); ++c) {
        if (plan.states[i][c] != plan.states[i + 1][c]) concern(ComponentId(c));
      }
    }
    for (std::size_t next = 0; next < all_.size(); ++next) {
      for (const automata::Transition& t : step.plant()[all_[next]].transitions) {
        if (t.guard.is_true()) continue;
        for (const ComponentId c : step.locality().support_of(t.guard).components) concern(c);
      }
    }
    std::sort(all_.begin(), all_.end());
  }

  /// Those that the goal and the plan have to do with.
  [[nodiscard]] const std::vector<ComponentId>& concerned() const { return all_; }

  /// Whether the steps from one on still lead to the goal where a component has come to a mode before that, and to
  /// those where time may take it from there.
  bool bears(std::size_t from, ComponentId component, automata::ModeId now) {
    std::vector<automata::ModeId> come_to = {now};
    for (std::size_t next = 0; next < come_to.size(); ++next) {
      automata::Modes there = plan_.states[from];
      there[component.index()] = come_to[next];
      if (!step_.possible(there)) continue;
      if (!arrives(from, there)) return false;
      if (!step_.permits(there, plan_.commands[from])) continue;
      for (const TransitionId id : step_.enabled(component, there, plan_.commands[from]).timed) {
        const automata::Transition& t = step_.plant()[component].transitions[id.index()];
        const bool known = std::find(come_to.begin(), come_to.end(), t.to) != come_to.end();
        if (!known && !t.timing->upper.is_infinite() && t.to != plan_.states[from][component.index()]) {
          come_to.push_back(t.to);
        }
      }
    }
    return true;
  }

 private:
  /// From a state in place of the plan's, with all that it brings about at once.
  bool arrives(std::size_t from, const automata::Modes& there) {
    modes_ = rested(there, all_, step_);
    for (std::size_t i = from; i < plan_.commands.size(); ++i) {
      if (!goes_on(i)) return false;
    }
    return step_.theory().entails(automata::assignments_of(step_.plant(), modes_), wanted_);
  }

  /// Whether what moves in a step of the plan comes to where that takes it, or is there before that.
  bool goes_on(std::size_t i) {
    if (!step_.permits(modes_, plan_.commands[i])) return false;
    automata::Modes next = modes_;
    for (const ComponentId c : all_) {
      const automata::ModeId to = plan_.states[i + 1][c.index()];
      if (plan_.states[i][c.index()] == to || modes_[c.index()] == to) continue;
      const auto leads_there = [&](TransitionId id) { return step_.plant()[c].transitions[id.index()].to == to; };
      const automata::Enabled& enabled = step_.enabled(c, modes_, plan_.commands[i]);
      if (std::none_of(enabled.untimed.begin(), enabled.untimed.end(), leads_there) &&
          std::none_of(enabled.timed.begin(), enabled.timed.end(), leads_there)) {
        return false;
      }
      next[c.index()] = to;
    }
    modes_ = std::move(next);
    return step_.possible(modes_);
  }

  const Plan& plan_;
  automata::PlantStep& step_;
  automata::Theory::Handle wanted_;
  std::vector<bool> concerned_;
  std::vector<ComponentId> all_;
  automata::Modes modes_;
};

}  // namespace

std::vector<PlanRisk> risks_of(const Plan& plan, automata::PlantStep& step, const automata::Formula& goal) {
  std::vector<PlanRisk> risks;
  Replay replay(plan, step, goal);
  const automata::ControlAction idle = idle_action(step.plant());
  for (std::size_t i = 0; i < plan.commands.size(); ++i) {
    const std::vector<ComponentId> waiting = waited_for(plan, i, step.plant());
    if (waiting.empty() && plan.commands[i] != idle) continue;
    for (const TransitionOf& leaving : lost_at_once(plan, i, step, waiting)) risks.push_back({i, leaving});
    for (const ComponentId component : replay.concerned()) {
      if (plan.states[i][component.index()] != plan.states[i + 1][component.index()]) continue;
      const std::vector<TransitionId> timed = step.enabled(component, plan.states[i], plan.commands[i]).timed;
      const auto leaving = std::find_if(timed.begin(), timed.end(), [&](TransitionId id) {
        const automata::Transition& t = step.plant()[component].transitions[id.index()];
        return t.to != t.from && !t.timing->upper.is_infinite() && !replay.bears(i, component, t.to);
      });
      if (leaving != timed.end()) risks.push_back({i, {component, *leaving}});
    }
  }
  return risks;
}

std::vector<TransitionOf> lost_in_the_end(const Plan& plan, automata::PlantStep& step, const automata::Formula& goal) {
  std::vector<TransitionOf> result;
  const automata::ControlAction idle = idle_action(step.plant());
  if (plan.outcome == Plan::Outcome::no_plan || !plan.goal_state || !step.permits(*plan.goal_state, idle)) return {};
  const automata::Theory::Handle wanted = step.theory().encode(goal);
  for (std::size_t c = 0; c < plan.goal_state->size(); ++c) {
    const ComponentId component(c);
    for (const TransitionId id : step.enabled(component, *plan.goal_state, idle).untimed) {
      automata::Modes after = *plan.goal_state;
      after[c] = step.plant()[component].transitions[id.index()].to;
      if (step.theory().entails(automata::assignments_of(step.plant(), after), wanted)) continue;
      result.push_back({component, id});
      break;
    }
  }
  return result;
}

}  // namespace rmpl::runtime
