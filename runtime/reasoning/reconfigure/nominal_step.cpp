// The nominal successors of a state.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/nominal_step.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::Enabled;
using automata::Modes;
using automata::TransitionId;

namespace {

bool contains(const std::vector<TransitionId>& ids, TransitionId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

double share(const automata::Transition& t) {
  return t.weight.kind == automata::Weight::Kind::none ? 1.0 : t.weight.value;
}

}  // namespace

NominalStep::NominalStep(automata::PlantStep& step, const NominalGraph& graph, const Parts& parts)
    : step_(step), graph_(graph), parts_(parts), readers_(step.plant().controls.size()) {
  const automata::PlantIndex index(plant());
  for (const ComponentId c : graph.components()) {
    for (const NominalTransition& t : graph.transitions(c)) {
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          const auto i = index.control_of(r.variable);
          if (i && (readers_[*i].empty() || readers_[*i].back().transition != &t)) readers_[*i].push_back({c, &t});
        }
      }
    }
  }
}

const NominalTransition& NominalStep::nominal(ComponentId component, TransitionId id) const {
  const NominalTransition* const transition = graph_.find(component, id);
  CHECK(transition != nullptr && "what is enabled in a consistent store can be brought about");
  return *transition;
}

const NominalTransition* NominalStep::heaviest(ComponentId component, const Enabled& enabled) const {
  if (enabled.untimed.empty()) return nullptr;
  const auto& transitions = plant()[component].transitions;
  return &nominal(
      component, *std::max_element(enabled.untimed.begin(), enabled.untimed.end(), [&](TransitionId a, TransitionId b) {
        return share(transitions[a.index()]) < share(transitions[b.index()]);
      }));
}

std::vector<NominalOutcome> NominalStep::combinations(const Modes& modes, const automata::AllEnabled& enabled,
                                                      std::size_t part, std::optional<NominalMove> fixed) const {
  std::vector<NominalOutcome> all{{modes, {}}};
  for (const ComponentId c : parts_.components(part)) {
    const auto& untimed = enabled[c.index()].untimed;
    if (untimed.empty()) continue;
    std::vector<NominalOutcome> extended;
    for (const NominalOutcome& outcome : all) {
      for (const TransitionId id : untimed) {
        const NominalTransition& t = nominal(c, id);
        if (fixed && fixed->component == c && fixed->transition != &t) continue;
        NominalOutcome& next = extended.emplace_back(outcome);
        if (t.from == t.to) continue;
        next.modes[c.index()] = t.to;
        next.moves.push_back({c, &t});
      }
    }
    all = std::move(extended);
  }
  return all;
}

bool NominalStep::permits(const Modes& modes, const ControlAction& action, const automata::AllEnabled& with,
                          std::size_t part, const Permitted& permitted, std::optional<ComponentId> intended,
                          const Modes* keep) {
  refused_.reset();
  const ControlAction idle = idle_action(plant());
  if (action == idle) return true;
  // Where the model does not tolerate idle controls, nothing happens without a command.
  static const Enabled nothing;
  const automata::AllEnabled* const idling = step_.enabled_if_permitted(modes, idle);
  const auto without = idling != nullptr ? std::optional(*idling) : std::nullopt;
  const auto may_come = [&](ComponentId c, const NominalTransition& t) {
    return is_granted(c, t, permitted) || comes_anyway(modes, c, t);
  };
  for (const ComponentId c : parts_.components(part)) {
    const Enabled& anyway = without ? (*without)[c.index()] : nothing;
    if (&with[c.index()] == &anyway) continue;
    for (const TransitionId id : with[c.index()].untimed) {
      const NominalTransition& t = nominal(c, id);
      if (t.from == t.to || contains(anyway.untimed, id)) continue;
      const bool undoes = c != intended && keep != nullptr && (*keep)[c.index()] == t.from;
      const bool may = may_come(c, t);
      if (may && !undoes) continue;
      const auto ways = combinations(modes, with, part, NominalMove{c, &t});
      if (std::any_of(ways.begin(), ways.end(), [&](const NominalOutcome& o) { return step_.possible(o.modes); })) {
        if (!may) refused_ = TransitionOf{c, id};
        return false;
      }
    }
    for (const TransitionId id : with[c.index()].timed) {
      const NominalTransition& t = nominal(c, id);
      if (t.from == t.to || contains(anyway.timed, id) || !t.possible || may_come(c, t)) continue;
      refused_ = TransitionOf{c, id};
      return false;
    }
  }
  return true;
}

std::optional<NominalOutcome> NominalStep::take(const Modes& modes, const ControlAction& action, NominalMove move,
                                                const Permitted& permitted, const Modes* keep) {
  const std::size_t part = parts_.of(move.component);
  refused_.reset();
  const automata::AllEnabled* const tolerated = step_.enabled_if_permitted(modes, action);
  if (tolerated == nullptr) return std::nullopt;
  const automata::AllEnabled enabled = *tolerated;
  if (!permits(modes, action, enabled, part, permitted, move.component, keep)) return std::nullopt;
  NominalOutcome outcome{modes, {}};
  for (const ComponentId c : parts_.components(part)) {
    const auto& untimed = enabled[c.index()].untimed;
    const NominalTransition* taken = nullptr;
    if (c == move.component) {
      const bool possible = move.transition->timed
                                ? untimed.empty() && contains(enabled[c.index()].timed, move.transition->id)
                                : contains(untimed, move.transition->id);
      if (!possible) return std::nullopt;
      taken = move.transition;
    } else {
      taken = heaviest(c, enabled[c.index()]);
    }
    if (taken == nullptr || taken->from == taken->to) continue;
    outcome.modes[c.index()] = taken->to;
    outcome.moves.push_back({c, taken});
  }
  if (!step_.possible(outcome.modes)) return std::nullopt;
  if (action == idle_action(plant())) return outcome;
  // What is left to chance, or to time, counts as well.
  if (risks(modes, outcome.modes, part, permitted)) return std::nullopt;
  for (const NominalOutcome& other : combinations(modes, enabled, part, {})) {
    if (other.modes == outcome.modes || !step_.possible(other.modes)) continue;
    if (risks(modes, other.modes, part, permitted)) return std::nullopt;
  }
  return lets_come_a_risk(modes, action, part, permitted) ? std::nullopt : std::optional(std::move(outcome));
}

bool NominalStep::join_others(const Modes& modes, const ControlAction& action, std::size_t part,
                              NominalOutcome& outcome) {
  const auto join = [&outcome](const std::vector<NominalMove>& moves) {
    for (const NominalMove& move : moves) {
      outcome.modes[move.component.index()] = move.transition->to;
      outcome.moves.push_back(move);
    }
  };
  const automata::AllEnabled enabled = step_.enabled(modes, action);
  for (std::size_t other = 0; other < parts_.count(); ++other) {
    if (other == part) continue;
    NominalOutcome drift{modes, {}};
    for (const ComponentId c : parts_.components(other)) {
      const NominalTransition* const taken = heaviest(c, enabled[c.index()]);
      if (taken == nullptr || taken->from == taken->to) continue;
      drift.modes[c.index()] = taken->to;
      drift.moves.push_back({c, taken});
    }
    if (drift.moves.empty()) continue;
    if (step_.possible(drift.modes)) {
      join(drift.moves);
    } else {
      const std::vector<NominalOutcome> ways = combinations(modes, enabled, other, {});
      const auto way =
          std::find_if(ways.begin(), ways.end(), [&](const NominalOutcome& o) { return step_.possible(o.modes); });
      if (way == ways.end()) return false;
      join(way->moves);
    }
  }
  return true;
}

std::vector<NominalMove> NominalStep::fleeting(const Modes& modes, const ControlAction& action, std::size_t part) {
  std::vector<NominalMove> result;
  if (!tolerates(modes, action)) return result;
  const automata::AllEnabled& enabled = step_.enabled(modes, action);
  for (const ComponentId c : parts_.components(part)) {
    for (const TransitionId id : enabled[c.index()].timed) {
      const NominalTransition& t = nominal(c, id);
      if (t.bounded && t.from != t.to && t.possible) result.push_back({c, &t});
    }
  }
  return result;
}

std::vector<Modes> NominalStep::let_come(const Modes& modes, const ControlAction& action, std::size_t part) {
  std::vector<Modes> result;
  const ControlAction idle = idle_action(plant());
  if (action == idle) return result;
  const automata::AllEnabled* const idling = step_.enabled_if_permitted(modes, idle);
  if (idling == nullptr) return result;
  const automata::AllEnabled without = *idling;
  const automata::AllEnabled& with = step_.enabled(modes, action);
  const auto is_new = [&](const NominalMove& move) {
    const Enabled& anyway = without[move.component.index()];
    return !contains(move.transition->timed ? anyway.timed : anyway.untimed, move.transition->id);
  };
  for (const NominalOutcome& at_once : combinations(modes, with, part, {})) {
    if (std::any_of(at_once.moves.begin(), at_once.moves.end(), is_new)) result.push_back(at_once.modes);
    for (const ComponentId c : parts_.components(part)) {
      const Enabled& enabled = with[c.index()];
      if (!enabled.untimed.empty() || &enabled == &without[c.index()]) continue;
      for (const TransitionId id : enabled.timed) {
        const NominalTransition& t = nominal(c, id);
        if (t.from == t.to || !t.possible || !is_new({c, &t})) continue;
        result.push_back(at_once.modes);
        result.back()[c.index()] = t.to;
      }
    }
  }
  std::erase_if(result, [&](const Modes& next) { return !step_.possible(next); });
  return result;
}

bool NominalStep::springs_back(const Modes& modes, const ControlAction& action, ComponentId component) {
  if (!tolerates(modes, action)) return false;
  const auto& untimed = step_.enabled(component, modes, action).untimed;
  return std::any_of(untimed.begin(), untimed.end(), [&](TransitionId id) {
    const NominalTransition& t = nominal(component, id);
    return t.from != t.to && t.possible;
  });
}

NominalStep::Rest NominalStep::rest(const Modes& modes) {
  const ControlAction idle = idle_action(plant());
  Rest rest{std::vector<automata::ValueId>(plant().variables.size()), tolerates(modes, idle)};
  for (const ComponentId c : graph_.components()) {
    rest.values[plant()[c].mode.index()] = automata::ValueId(modes[c.index()].index());
  }
  for (std::size_t i = 0; i < idle.size(); ++i) rest.values[plant().controls[i].variable.index()] = idle[i];
  return rest;
}

bool NominalStep::matters(Rest& rest, const OffIdle& off) const {
  if (!rest.tolerated) return true;
  const auto met = [&](const Requirement& r) {
    return std::binary_search(r.values.begin(), r.values.end(), rest.values[r.variable.index()]);
  };
  const auto enabled = [&](const NominalTransition& t) {
    return std::any_of(t.preconditions.begin(), t.preconditions.end(),
                       [&](const Precondition& p) { return std::all_of(p.begin(), p.end(), met); });
  };
  const auto put = [&](bool idle) {
    for (const auto& [i, value] : off) {
      rest.values[plant().controls[i].variable.index()] = idle ? plant().controls[i].idle : value;
    }
  };
  const auto changes = [&](const NominalMove& reader) {
    const NominalTransition& t = *reader.transition;
    if (rest.values[plant()[reader.component].mode.index()].index() != t.from.index()) return false;
    if (!t.all_preconditions) return true;
    const bool anyway = enabled(t);
    put(false);
    const bool then = enabled(t);
    put(true);
    return then != anyway;
  };
  return std::any_of(off.begin(), off.end(), [&](const auto& control) {
    const auto& readers = readers_[control.first];
    return std::any_of(readers.begin(), readers.end(), changes);
  });
}

std::vector<NominalOutcome> NominalStep::outcomes(const Modes& modes, const ControlAction& action, std::size_t part,
                                                  const Permitted& permitted) {
  std::vector<NominalOutcome> result;
  refused_.reset();
  const automata::AllEnabled* const tolerated = step_.enabled_if_permitted(modes, action);
  if (tolerated == nullptr) return result;
  const automata::AllEnabled enabled = *tolerated;
  if (!permits(modes, action, enabled, part, permitted, {}, nullptr)) return result;
  std::vector<NominalOutcome> all = combinations(modes, enabled, part, {});
  const bool moves = std::any_of(all.begin(), all.end(), [](const NominalOutcome& o) { return !o.moves.empty(); });
  if (!moves) {
    all.clear();
    for (const ComponentId c : parts_.components(part)) {
      if (!enabled[c.index()].untimed.empty()) continue;
      for (const TransitionId id : enabled[c.index()].timed) {
        const NominalTransition& t = nominal(c, id);
        if (t.from == t.to) continue;
        NominalOutcome& next = all.emplace_back(NominalOutcome{modes, {{c, &t}}});
        next.modes[c.index()] = t.to;
      }
    }
  }
  const bool commanded = action != idle_action(plant());
  if (commanded && lets_come_a_risk(modes, action, part, permitted)) return {};
  for (NominalOutcome& outcome : all) {
    if (outcome.moves.empty() || !step_.possible(outcome.modes)) continue;
    if (commanded && risks(modes, outcome.modes, part, permitted)) return {};
    result.push_back(std::move(outcome));
  }
  return result;
}

}  // namespace rmpl::runtime
