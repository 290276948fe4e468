// The reactive planner: which waits a plan survives, because no mode that it relies on ends meanwhile, and what else is
// done while it waits.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "runtime/reasoning/reconfigure/planner.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;

const Planner::Followed& Planner::Reliance::way() {
  if (!way_) way_ = planner_.followed_in_part(modes_, objective_);
  return *way_;
}

bool Planner::Reliance::is_safe(const ControlAction& action, const NominalOutcome& outcome) {
  const auto& moves = outcome.moves;
  const auto takes_time = [](const NominalMove& m) { return m.transition->timed; };
  if (std::none_of(moves.begin(), moves.end(), takes_time)) return true;
  // What is waited for does not come any more where something else takes its ground away at once.
  Modes at_once = modes_;
  for (const NominalMove& move : moves) {
    if (!takes_time(move)) at_once[move.component.index()] = move.transition->to;
  }
  const auto goes_on = [&](const NominalMove& move) {
    return !takes_time(move) || planner_.stands(*move.transition, at_once);
  };
  if (!std::all_of(moves.begin(), moves.end(), goes_on)) return false;
  const std::vector<NominalMove>& others = threats(action);
  return std::none_of(others.begin(), others.end(), [&](const NominalMove& leaving) {
    return outcome.modes[leaving.component.index()] == modes_[leaving.component.index()];
  });
}

const std::vector<NominalMove>& Planner::Reliance::threats(const ControlAction& action) {
  if (!threats_ || threats_->first != action) {
    std::vector<NominalMove> found = planner_.nominal_.fleeting(modes_, action, objective_.part);
    std::erase_if(found, [&](const NominalMove& leaving) {
      return !way().relied[leaving.component.index()] && !upsets(leaving);
    });
    threats_.emplace(action, std::move(found));
  }
  return threats_->second;
}

bool Planner::Reliance::upsets(const NominalMove& leaving) {
  Modes left = modes_;
  left[leaving.component.index()] = leaving.transition->to;
  const auto is_lost = [&](ComponentId c, ModeId now) {
    if (now == modes_[c.index()]) return false;
    if (way().relied[c.index()]) return true;
    if (!way().moved[c.index()]) return false;
    const Policy& policy = planner_.policies_.of(c, objective_.permitted);
    return std::any_of(way().sought.begin(), way().sought.end(), [&](const auto& aim) {
      if (aim.first != c) return false;
      const auto& then = policy.distance(now, aim.second);
      return !then || policy.distance(modes_[c.index()], aim.second) < then;
    });
  };
  for (const Consequence& next : planner_.nominal_.aftermath(left, objective_.part)) {
    const bool lost = std::any_of(next.moves.begin(), next.moves.end(), [&](const TransitionOf& move) {
      return move.component != leaving.component && is_lost(move.component, next.modes[move.component.index()]);
    });
    if (lost) return true;
  }
  return false;
}

bool Planner::Reliance::gives_up(const NominalOutcome& outcome) {
  const auto leaves = [&](const NominalMove& move) {
    return move.transition->to != move.transition->from && !planner_.astray(modes_, objective_, move.component) &&
           !(objective_.wanted[move.component.index()] && move.transition->timed) &&
           !planner_.nominal_.springs_back(modes_, planner_.idle_, move.component);
  };
  if (std::none_of(outcome.moves.begin(), outcome.moves.end(), leaves)) return false;
  const std::vector<bool>& relied = way().relied;
  return std::any_of(outcome.moves.begin(), outcome.moves.end(),
                     [&](const NominalMove& move) { return leaves(move) && relied[move.component.index()]; });
}

/// Whether the modes meet what some precondition of the transition asks of other components.
bool Planner::stands(const NominalTransition& transition, const Modes& modes) const {
  return std::any_of(transition.preconditions.begin(), transition.preconditions.end(), [&](const Precondition& p) {
    return std::all_of(p.begin(), p.end(), [&](const Requirement& r) {
      const auto other = index_.component_of(r.variable);
      return !other || std::binary_search(r.values.begin(), r.values.end(), ValueId(modes[other->index()].index()));
    });
  });
}

Planner::Followed Planner::followed_in_part(const Modes& modes, const Objective& objective) {
  std::vector<ComponentId> seeds;
  for (const ComponentId c : parts_.components(objective.part)) {
    if (objective.wanted[c.index()]) seeds.push_back(c);
  }
  return followed(modes, objective, seeds, Follow::nearest_ways);
}

Planner::Followed Planner::followed(const Modes& modes, const Objective& objective) {
  std::vector<ComponentId> seeds;
  for (std::size_t c = 0; c < modes.size(); ++c) {
    if (objective.wanted[c]) seeds.emplace_back(c);
  }
  return followed(modes, objective, seeds, Follow::every_way);
}

Planner::Followed Planner::followed(const Modes& modes, const Objective& objective, std::span<const ComponentId> seeds,
                                    Follow follow) {
  Followed result{std::vector<bool>(modes.size()), std::vector<bool>(modes.size()), false, {}};
  std::vector<std::pair<ComponentId, ModeId>> open;
  const auto seek = [&](ComponentId c, ModeId wanted) {
    if (modes[c.index()] == wanted) {
      result.relied[c.index()] = true;
    } else if (result.sought.emplace(c, wanted).second) {
      open.emplace_back(c, wanted);
      result.moved[c.index()] = true;
    }
  };
  const auto rely = [&](ComponentId component, const Precondition& precondition) {
    for (const Requirement& r : precondition) {
      const auto upstream = index_.component_of(r.variable);
      if (!upstream || *upstream == component) continue;
      if (follow == Follow::nearest_ways && ModeRequirement{*upstream, &r}.met(modes)) {
        result.relied[upstream->index()] = true;
        continue;
      }
      for (const automata::ValueId v : r.values) seek(*upstream, ModeId(v.index()));
    }
  };
  const auto rely_on_nearest = [&](ComponentId component, const NominalTransition& t) {
    const std::vector<Choice> ways = choices(modes, objective, component, t);
    for (const Choice& choice : ways) {
      if (choice.detour == ways.front().detour) rely(component, *choice.way->precondition);
    }
  };
  const auto rely_on_all = [&](ComponentId component, const NominalTransition& t) {
    for (const NominalTransition& way : graph_.transitions(component)) {
      if (!is_parallel(component, way, t, objective.permitted)) continue;
      for (const Precondition& precondition : way.preconditions) rely(component, precondition);
    }
  };
  for (const ComponentId c : seeds) seek(c, objective.target[c.index()]);
  while (!open.empty()) {
    const ComponentId component = open.back().first;
    const ModeId wanted = open.back().second;
    open.pop_back();
    const Policy& policy = policies_.of(component, objective.permitted);
    const ModeId mode = modes[component.index()];
    const Route way = route(modes, objective, component, wanted);
    // Where time takes it to a mode that is no farther from the target, nothing is lost.
    const bool strays =
        std::any_of(graph_.transitions(component).begin(), graph_.transitions(component).end(),
                    [&](const NominalTransition& leaving) {
                      const auto& left = policy.distance(leaving.to, wanted);
                      return leaving.from == mode && leaving.timed && (!left || policy.distance(mode, wanted) < left);
                    });
    if (!way.empty() && !way.front()->timed && strays) result.relied[component.index()] = true;
    for (const NominalTransition* const t : way) {
      result.waits = result.waits || t->timed;
      if (follow == Follow::nearest_ways && !order_.in_cycle(component)) {
        rely_on_nearest(component, *t);
      } else {
        rely_on_all(component, *t);
      }
    }
  }
  return result;
}

std::optional<PlannedStep> Planner::meanwhile(const Modes& modes, const Objective& objective,
                                              const PlannedStep& waiting) {
  const ComponentId served = waiting.serves;
  const Followed way = followed(modes, objective, std::span(&served, 1), Follow::every_way);
  const auto waits_on = [&](const Modes& after) {
    if (!astray(after, objective, served)) return false;
    const NextStep next = approach(after, objective, served);
    const auto* const step = std::get_if<PlannedStep>(&next);
    return step != nullptr && step->idle && step->component == waiting.component;
  };
  const auto prepare = [&](ComponentId c) {
    auto step = preparation(modes, objective, c, std::span(&objective.target[c.index()], 1),
                            [&](const PlannedStep& command) { return waits_on(command.outcome.modes); });
    if (step) step->serves = c;
    return step;
  };
  for (const ComponentId c : ordered_[objective.part]) {
    if (way.relied[c.index()] || way.moved[c.index()] || !astray(modes, objective, c)) continue;
    if (auto step = prepare(c)) return step;
  }
  return prepare(served);
}

bool Planner::is_brief(const PlannedStep& step, const Objective& objective) {
  const Modes& reached = step.outcome.modes;
  const std::vector<NominalMove> brief = brief_goals(reached, objective);
  return std::any_of(step.outcome.moves.begin(), step.outcome.moves.end(), [&](const NominalMove& move) {
    return std::any_of(brief.begin(), brief.end(), [&](const NominalMove& b) { return b.component == move.component; });
  });
}

bool Planner::is_brief(const IslandPlan& plan, const Objective& objective) {
  if (is_brief(plan.first, objective)) return true;
  return !has_waits(plan.first.outcome.modes, objective) && !brief_goals(plan.end, objective).empty();
}

bool Planner::is_passing(const PlannedStep& step, const Objective& objective) {
  const Modes& reached = step.outcome.modes;
  return std::any_of(step.outcome.moves.begin(), step.outcome.moves.end(), [&](const NominalMove& move) {
    const ComponentId c = move.component;
    return objective.wanted[c.index()] && reached[c.index()] == objective.target[c.index()] &&
           nominal_.springs_back(reached, idle_, c);
  });
}

/// The goals that are achieved, and may be undone by a timed transition of their own.
std::vector<NominalMove> Planner::brief_goals(const Modes& modes, const Objective& objective) {
  std::vector<NominalMove> brief = nominal_.fleeting(modes, idle_, objective.part);
  std::erase_if(brief, [&](const NominalMove& m) {
    return !objective.wanted[m.component.index()] || astray(modes, objective, m.component);
  });
  return brief;
}

bool Planner::has_waits(const Modes& modes, const Objective& objective) {
  return followed_in_part(modes, objective).waits;
}

}  // namespace rmpl::runtime
