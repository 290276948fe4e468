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
                                                      std::size_t island, std::optional<NominalMove> fixed) const {
  std::vector<NominalOutcome> all{{modes, {}}};
  for (const ComponentId c : islands_.components(island)) {
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

bool NominalStep::permits(const Modes& modes, const ControlAction& action, std::size_t island, const NamedModes& named,
                          const NominalMove* intended, const Modes* keep) {
  const ControlAction idle = idle_action(plant());
  if (action == idle) return true;
  const automata::AllEnabled without = step_.enabled(modes, idle);
  const automata::AllEnabled with = step_.enabled(modes, action);
  for (const ComponentId c : islands_.components(island)) {
    if (&with[c.index()] == &without[c.index()]) continue;
    const auto& names = named[c.index()];
    const bool own = intended != nullptr && intended->component == c;
    for (const TransitionId id : with[c.index()].untimed) {
      const NominalTransition& t = nominal(c, id);
      if (t.from == t.to || contains(without[c.index()].untimed, id) || (own && intended->transition == &t)) continue;
      const bool undoes = !own && keep != nullptr && (*keep)[c.index()] == t.from;
      if (NominalGraph::permitted(t, names) && !undoes) continue;
      const auto ways = combinations(modes, with, island, NominalMove{c, &t});
      if (std::any_of(ways.begin(), ways.end(), [&](const NominalOutcome& o) { return step_.possible(o.modes); })) {
        return false;
      }
    }
    for (const TransitionId id : with[c.index()].timed) {
      const NominalTransition& t = nominal(c, id);
      if (t.from == t.to || contains(without[c.index()].timed, id) || (own && intended->transition == &t)) continue;
      const bool undone = t.reversible || t.repair || names[t.to.index()];
      if (intended != nullptr && !undone) return false;
    }
  }
  return true;
}

std::optional<NominalOutcome> NominalStep::take(const Modes& modes, const ControlAction& action, NominalMove move,
                                                const NamedModes& named, const Modes* keep) {
  const std::size_t island = islands_.of(move.component);
  if (!tolerates(modes, action) || !permits(modes, action, island, named, &move, keep)) return std::nullopt;
  const automata::AllEnabled& enabled = step_.enabled(modes, action);
  NominalOutcome outcome{modes, {}};
  for (const ComponentId c : islands_.components(island)) {
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
  return outcome;
}

bool NominalStep::join_others(const Modes& modes, const ControlAction& action, std::size_t island,
                              const NamedModes& named, NominalOutcome& outcome) {
  const auto join = [&outcome](const std::vector<NominalMove>& moves) {
    for (const NominalMove& move : moves) {
      outcome.modes[move.component.index()] = move.transition->to;
      outcome.moves.push_back(move);
    }
  };
  const automata::AllEnabled enabled = step_.enabled(modes, action);
  for (std::size_t other = 0; other < islands_.count(); ++other) {
    if (other == island) continue;
    NominalOutcome drift{modes, {}};
    for (const ComponentId c : islands_.components(other)) {
      const NominalTransition* const taken = heaviest(c, enabled[c.index()]);
      if (taken == nullptr || taken->from == taken->to) continue;
      drift.modes[c.index()] = taken->to;
      drift.moves.push_back({c, taken});
    }
    if (drift.moves.empty()) continue;
    if (step_.possible(drift.modes)) {
      join(drift.moves);
    } else {
      const std::vector<NominalOutcome> ways = outcomes(modes, action, other, named);
      if (ways.empty()) return false;
      join(ways.front().moves);
    }
  }
  return true;
}

std::vector<ComponentId> NominalStep::fleeting(const Modes& modes, const ControlAction& action, std::size_t island) {
  std::vector<ComponentId> result;
  if (!tolerates(modes, action)) return result;
  const automata::AllEnabled& enabled = step_.enabled(modes, action);
  for (const ComponentId c : islands_.components(island)) {
    const auto& timed = enabled[c.index()].timed;
    const auto leaves = [&](TransitionId id) {
      const NominalTransition& t = nominal(c, id);
      return t.bounded && t.from != t.to && t.possible;
    };
    if (std::any_of(timed.begin(), timed.end(), leaves)) result.push_back(c);
  }
  return result;
}

std::vector<NominalOutcome> NominalStep::outcomes(const Modes& modes, const ControlAction& action, std::size_t island,
                                                  const NamedModes& named) {
  std::vector<NominalOutcome> result;
  if (!tolerates(modes, action) || !permits(modes, action, island, named, nullptr, nullptr)) return result;
  const automata::AllEnabled enabled = step_.enabled(modes, action);
  std::vector<NominalOutcome> all = combinations(modes, enabled, island, {});
  const bool moves = std::any_of(all.begin(), all.end(), [](const NominalOutcome& o) { return !o.moves.empty(); });
  if (!moves) {
    all.clear();
    for (const ComponentId c : islands_.components(island)) {
      if (!enabled[c.index()].untimed.empty()) continue;
      for (const TransitionId id : enabled[c.index()].timed) {
        const NominalTransition& t = nominal(c, id);
        if (t.from == t.to) continue;
        NominalOutcome& next = all.emplace_back(NominalOutcome{modes, {{c, &t}}});
        next.modes[c.index()] = t.to;
      }
    }
  }
  for (NominalOutcome& outcome : all) {
    if (!outcome.moves.empty() && step_.possible(outcome.modes)) result.push_back(std::move(outcome));
  }
  return result;
}

}  // namespace rmpl::runtime
