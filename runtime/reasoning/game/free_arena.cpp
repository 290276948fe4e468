// Positions in which components outside are free: all that their preconditions leave open is chosen.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/game/free_arena.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "runtime/reasoning/nominal/idling.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::ControlAction;
using automata::ModeId;
using automata::Modes;
using automata::ValueId;

namespace {

constexpr std::size_t most_open_steps = 4;  // of one component; beyond it the arena is too large

bool permits(const Requirement& requirement, ValueId value) {
  return std::binary_search(requirement.values.begin(), requirement.values.end(), value);
}

}  // namespace

FreeArena::FreeArena(automata::PlantStep& step, const NominalGraph& graph, const GameGoal& goal,
                     std::vector<std::size_t> parts, std::vector<ComponentId> components, const Modes& start,
                     Excludes excludes, const WithinReach& reach)
    : Arena(step, graph, goal, std::move(parts), std::move(components), start, excludes),
      reach_(reach),
      place_(plant().variables.size()) {
  for (std::size_t i = 0; i < plant().controls.size(); ++i) place_[plant().controls[i].variable.index()] = i;
  for (const ComponentId c : graph.components()) others_move_ = others_move_ || may_help(c);
  const auto& islands = step.locality().islands();
  for (std::size_t i = 0; i < islands.size() && others_move_ && !exclude_; ++i) {
    const auto& together = islands[i].support.components;
    exclude_ =
        std::any_of(together.begin(), together.end(), [&](ComponentId c) { return is_member(c); }) && excludes(i);
  }
  for (const ComponentId c : graph.components()) {
    if (!is_member(c) && !may_help(c)) held_.push_back({plant()[c].mode, ValueId(start[c.index()].index())});
  }
}

bool FreeArena::may_help(ComponentId c) const {
  const auto& modes = reach_.modes[c.index()];
  return !is_member(c) && std::count(modes.begin(), modes.end(), true) > 1;
}

bool FreeArena::is_barred(ComponentId c, const LocalMoves& moves) const {
  return std::any_of(moves.exits.begin(), moves.exits.end(), [&](const LocalMoves::Exit& exit) {
    const NominalTransition* const t = graph_.find(c, exit.transition);
    return t != nullptr && reach_.barred[c.index()][graph_.position(c, *t)];
  });
}

/// Where the others are free: together with some of their modes.
bool FreeArena::tolerates(const Modes& modes, bool free) {
  if (!free) return Arena::tolerates(modes, free);
  if (!exclude_) return true;
  std::vector<automata::Assignment> assumed = held_;
  assumed.reserve(held_.size() + components().size());
  for (const ComponentId c : components()) assumed.push_back({plant()[c].mode, ValueId(modes[c.index()].index())});
  return step_.theory().consistent(assumed);
}

void FreeArena::list_actions(Position& position) {
  if (position.free) {
    list_free(position);
    return;
  }
  Arena::list_actions(position);
  auto& actions = position.actions;
  const auto barred = [&](const Position::Action& action) {
    for (std::size_t i = 0; i < components().size(); ++i) {
      if (is_barred(components()[i], *action.moves[i])) return true;
    }
    return false;
  };
  if (!actions.empty()) actions.erase(std::remove_if(actions.begin() + 1, actions.end(), barred), actions.end());
  if (!others_move_) return;
  const std::size_t count = actions.size();
  actions.reserve(2 * count);
  for (std::size_t a = 0; a < count; ++a) {
    Position::Action& action = actions.emplace_back(actions[a]);
    action.frees = action.ticks = true;
  }
}

std::vector<FreeArena::Step> FreeArena::steps_of(ComponentId c, const Modes& modes) const {
  std::vector<Step> steps;
  const bool known = graph_.deciding(c, modes[c.index()]).has_value();
  for (const NominalTransition& t : graph_.transitions(c)) {
    if (t.from != modes[c.index()]) continue;
    Step step{.transition = &t, .certain = {}, .possible = {}};
    step.unknown = !known || !t.all_preconditions;
    step.barred = reach_.barred[c.index()][graph_.position(c, t)];
    for (const Precondition& precondition : t.preconditions) {
      bool certain = true, possible = true;
      for (const Requirement& r : precondition) {
        const auto other = graph_.component_of(r);
        if (!other) continue;
        if (is_member(*other)) {
          possible = possible && permits(r, ValueId(modes[other->index()].index()));
          continue;
        }
        bool all = true, some = false;
        const auto& reached = reach_.modes[other->index()];
        for (std::size_t m = 0; m < reached.size(); ++m) {
          if (!reached[m]) continue;
          (permits(r, ValueId(m)) ? some : all) = permits(r, ValueId(m));
        }
        certain = certain && all;
        possible = possible && some;
      }
      if (possible) (certain ? step.certain : step.possible).push_back(&precondition);
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

bool FreeArena::commands(const Precondition& precondition, const ControlAction& action) const {
  return std::all_of(precondition.begin(), precondition.end(), [&](const Requirement& r) {
    return graph_.component_of(r).has_value() || permits(r, action[place_[r.variable.index()]]);
  });
}

/// What the component may do, for each choice of the steps that the others leave open; none where a step is certain
/// that no strategy takes.
std::vector<const LocalMoves*> FreeArena::choices(std::size_t member, ModeId mode, const std::vector<Step>& steps,
                                                  const ControlAction& action) {
  const ComponentId c = components()[member];
  const auto met = [&](const std::vector<const Precondition*>& all) {
    return std::any_of(all.begin(), all.end(), [&](const Precondition* p) { return commands(*p, action); });
  };
  std::vector<automata::TransitionId> certain, open;
  for (const Step& step : steps) {
    if (!step.unknown && met(step.certain)) {
      if (step.barred) return {};
      certain.push_back(step.transition->id);
    } else if (!step.barred && (step.unknown || met(step.possible))) {
      open.push_back(step.transition->id);
    }
  }
  if (open.size() > most_open_steps) {
    too_large_ = true;
    return {};
  }
  std::vector<const LocalMoves*> result;
  for (std::size_t chosen = 0; chosen < std::size_t{1} << open.size(); ++chosen) {
    std::vector<automata::TransitionId> taken = certain;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if ((chosen >> i & 1) != 0) taken.push_back(open[i]);
    }
    std::sort(taken.begin(), taken.end());
    automata::Enabled enabled;
    for (const automata::TransitionId t : taken) automata::add_enabled(enabled, plant()[c], t);
    const LocalMoves* const moves = kept(member, moves_with(c, mode, enabled));
    if (std::find(result.begin(), result.end(), moves) == result.end()) result.push_back(moves);
  }
  return result;
}

/// All combinations of the values that some step tells apart; of those that none does idle, else the first. None where
/// there are too many.
std::vector<ControlAction> FreeArena::actions_for(const std::vector<std::vector<Step>>& steps) const {
  std::map<std::size_t, std::vector<const Requirement*>> asked;  // by place of the control
  for (const auto& own : steps) {
    for (const Step& step : own) {
      for (const auto* const preconditions : {&step.certain, &step.possible}) {
        for (const Precondition* const p : *preconditions) {
          for (const Requirement& r : *p) {
            if (!graph_.component_of(r)) asked[place_[r.variable.index()]].push_back(&r);
          }
        }
      }
    }
  }
  std::vector<ControlAction> all{idle_};
  for (const auto& entry : asked) {
    const std::size_t i = entry.first;
    std::set<std::vector<bool>> known;
    const auto is_new = [&](ValueId value) {
      std::vector<bool> met;
      met.reserve(entry.second.size());
      for (const Requirement* const r : entry.second) met.push_back(permits(*r, value));
      return known.insert(std::move(met)).second;
    };
    is_new(idle_[i]);
    std::vector<ValueId> values;
    for (std::size_t v = 0; v < plant().variables[plant().controls[i].variable].values.size(); ++v) {
      if (is_new(ValueId(v))) values.emplace_back(v);
    }
    const std::size_t count = all.size();
    if (count * (values.size() + 1) > most_actions) return {};
    all.reserve(count * (values.size() + 1));
    for (std::size_t a = 0; a < count; ++a) {
      for (const ValueId v : values) all.emplace_back(all[a])[i] = v;
    }
  }
  return all;
}

void FreeArena::list_free(Position& position) {
  std::vector<std::vector<Step>> steps;
  steps.reserve(components().size());
  for (const ComponentId c : components()) steps.push_back(steps_of(c, position.modes));
  const std::vector<ControlAction> all = actions_for(steps);
  if (all.empty()) {
    too_large_ = true;
    return;
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> numbered;  // controls off idle, number
  numbered.reserve(all.size());
  for (const ControlAction& action : all) {
    const std::uint32_t number = number_of(action);
    numbered.emplace_back(static_cast<std::uint32_t>(order(number).size()), number);
  }
  std::sort(numbered.begin(), numbered.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : order(a.second) < order(b.second);
  });
  std::set<std::vector<const LocalMoves*>> known;
  for (const auto& [off, number] : numbered) {
    std::vector<std::vector<const LocalMoves*>> combined{{}};
    const ControlAction action = this->action(number);
    for (std::size_t i = 0; i < components().size(); ++i) {
      const auto own = choices(i, position.modes[components()[i].index()], steps[i], action);
      std::vector<std::vector<const LocalMoves*>> more;
      for (const auto& before : combined) {
        for (const LocalMoves* const moves : own) more.emplace_back(before).push_back(moves);
      }
      combined = std::move(more);
      if (combined.size() > most_actions) too_large_ = true;
      if (too_large_) return;
    }
    for (auto& moves : combined) {
      if (!known.insert(moves).second) continue;
      Position::Action& entry = position.actions.emplace_back();
      entry.action = number;
      entry.off = off;
      entry.moves = std::move(moves);
    }
    if (position.actions.size() > most_actions) {
      too_large_ = true;
      return;
    }
  }
  const std::size_t count = position.actions.size();
  position.actions.reserve(2 * count);
  for (std::size_t a = 0; a < count; ++a) position.actions.emplace_back(position.actions[a]).ticks = true;
}

std::vector<ComponentId> FreeArena::helpers(std::size_t member, const Modes& modes, automata::TransitionId exit,
                                            const ControlAction& action) const {
  std::optional<std::vector<ComponentId>> fewest;
  for (const Step& step : steps_of(components()[member], modes)) {
    if (step.transition->id != exit) continue;
    for (const auto* const preconditions : {&step.certain, &step.possible}) {
      for (const Precondition* const p : *preconditions) {
        if (!commands(*p, action)) continue;
        std::vector<ComponentId> lacking;
        for (const Requirement& r : *p) {
          const auto other = graph_.component_of(r);
          if (other && !is_member(*other) && !permits(r, ValueId(start_modes()[other->index()].index())))
            lacking.push_back(*other);
        }
        if (!fewest || lacking.size() < fewest->size()) fewest = std::move(lacking);
      }
    }
  }
  return fewest.value_or(std::vector<ComponentId>());
}

}  // namespace rmpl::runtime
