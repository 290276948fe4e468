// The reactive planner: the search of a part where the walk through the policies does not get there.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "runtime/reasoning/reconfigure/planner.hpp"

namespace rmpl::runtime {

using automata::Modes;

namespace {

/// Steps are cycles in which something happens that has to do with the goal. Of paths of one length that goes first
/// which loses less of what was achieved, then that with fewer steps that take time, as a wait lasts many cycles and a
/// command one; then that with fewer commands, then that with the earlier ones: what takes time is not waited for
/// before what can be commanded at once. Then that with the fewest cycles.
struct Cost {
  Distance distance;
  std::size_t losses = 0;  ///< how often a component that is to be where it is leaves it
  std::size_t delays = 0;  ///< steps in which something that has to do with the goal takes a timed transition
  std::size_t commands = 0;
  std::size_t late = 0;  ///< how many steps stand before each command, summed
  std::size_t cycles = 0;
  auto operator<=>(const Cost&) const = default;
};

/// A path to a state: what it costs, and the step that it begins with.
struct Path {
  Cost cost;
  std::size_t first;  ///< position among the first steps; `none` for the start
  Modes state;
  bool settled = false;
};
constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Best paths first; of equal ones that which was found first, so that ties go by the order of actions.
struct Entry {
  Cost cost;
  std::size_t found;
  Path* path;
  bool operator>(const Entry& other) const { return std::tie(cost, found) > std::tie(other.cost, other.found); }
};

}  // namespace

Planner::Upstream Planner::upstream(const Modes& modes, const Objective& objective, bool achieved) {
  Upstream found{std::vector<bool>(modes.size()), std::vector<bool>(nominal_.plant().variables.size())};
  std::vector<automata::ComponentId> open;
  const auto involve = [&](automata::ComponentId c) {
    if (found.components[c.index()]) return;
    found.components[c.index()] = true;
    open.push_back(c);
  };
  for (const automata::ComponentId c : parts_.components(objective.part)) {
    if (astray(modes, objective, c) || (achieved && objective.wanted[c.index()])) involve(c);
  }
  while (!open.empty()) {
    const automata::ComponentId c = open.back();
    open.pop_back();
    for (const NominalTransition& t : graph_.transitions(c)) {
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          found.variables[r.variable.index()] = true;
          if (const auto upstream = index_.component_of(r.variable)) involve(*upstream);
        }
      }
    }
  }
  return found;
}

std::vector<OffIdle> Planner::promising(const Modes& modes, const Objective& objective) {
  const std::vector<bool> useful = upstream(modes, objective, false).variables;
  std::vector<OffIdle> some;
  const auto& controls = nominal_.plant().controls;
  const auto& all = actions(objective.part);
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), [&](const OffIdle& action) {
    return std::all_of(action.begin(), action.end(),
                       [&](const auto& off) { return useful[controls[off.first].variable.index()]; });
  });
  return some;
}

/// Promising actions first; where they do not get there, all, but for a reward: nothing is moved only so that something
/// else may be worth more. Where the budget ends that, the promising ones again,
/// with states taken for one that differ in what has no part in the goal.
Planner::Found Planner::search(const Modes& modes, const Objective& objective, const Impasse& otherwise, Waits waits) {
  const auto& all = actions(objective.part);
  const std::vector<OffIdle> some = promising(modes, objective);
  const std::vector<bool> everything(modes.size(), true);
  const std::vector<bool> involved = upstream(modes, objective, true).components;
  Found found = search(modes, objective, otherwise, waits, {some, everything, involved, tried_});
  if (std::holds_alternative<PlannedStep>(found.first)) return found;
  if (!found.given_up && some.size() != all.size() && !objective.keeps) {
    found = search(modes, objective, otherwise, waits, {all, everything, involved, tried_});
    if (std::holds_alternative<PlannedStep>(found.first)) return found;
  }
  if (!found.given_up) return found;
  Found likely = search(modes, objective, otherwise, waits, {some, involved, involved, tried_alike_});
  return std::holds_alternative<PlannedStep>(likely.first) ? likely : found;
}

Planner::Found Planner::search_a_little(const Modes& modes, const Objective& objective) {
  const std::size_t before = tried_;
  const std::size_t before_alike = tried_alike_;
  const std::size_t start = trial_limit - shortcut_trials;
  tried_ = std::max(before, start);
  tried_alike_ = std::max(before_alike, start);
  Found found = search(modes, objective, Impasse{}, Waits::safe);
  tried_ = before + (tried_ - std::max(before, start));
  tried_alike_ = before_alike + (tried_alike_ - std::max(before_alike, start));
  return found;
}

/// Of what moves in a step, what its command brings about; else the first.
static automata::ComponentId moved_by(const NominalOutcome& outcome, bool idle) {
  const auto commanded = std::find_if(outcome.moves.begin(), outcome.moves.end(),
                                      [&](const NominalMove& move) { return !idle && move.transition->commanded; });
  return (commanded != outcome.moves.end() ? *commanded : outcome.moves.front()).component;
}

/// Of the components that are to move, the one for which another moves: itself, or the first on whose way it is.
automata::ComponentId Planner::served_by(const Modes& modes, const Objective& objective, automata::ComponentId moved) {
  if (astray(modes, objective, moved)) return moved;
  std::optional<automata::ComponentId> first;
  for (const automata::ComponentId c : ordered_[objective.part]) {
    if (!astray(modes, objective, c)) continue;
    if (followed(modes, objective, std::span(&c, 1), Follow::every_way).moved[moved.index()]) return c;
    if (!first) first = c;
  }
  return first.value_or(moved);
}

/// Uniform-cost search over the nominal successors of the whole part: fewest irreversible steps, then fewest steps that
/// have to do with the goal.
/// The same rules on irreversible steps hold; what is achieved may be undone on the path. Each path is one that can be
/// gone, whatever is taken for one.
Planner::Found Planner::search(const Modes& modes, const Objective& objective, Impasse otherwise, Waits waits,
                               const SearchSpace& space) {
  bool excluded = false;
  std::optional<TransitionOf> refused;  // the first that bars a way
  std::unordered_map<Modes, Path, automata::ModesHash> paths;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<PlannedStep> first_steps;
  std::size_t found = 0;
  std::size_t settled = 0;
  const auto offer = [&](const Modes& state, Cost cost, std::size_t first) {
    Modes alike = state;
    for (std::size_t c = 0; c < alike.size(); ++c) {
      if (!space.told_apart[c]) alike[c] = modes[c];
    }
    const auto [at, fresh] = paths.try_emplace(std::move(alike), Path{cost, first, state});
    if (!fresh && (at->second.settled || at->second.cost <= cost)) return;
    at->second = Path{cost, first, state};
    open.push({cost, found++, &at->second});
  };
  offer(modes, {}, none);
  while (!open.empty()) {
    const Entry entry = open.top();
    open.pop();
    if (entry.path->settled) continue;
    entry.path->settled = true;
    const Path reached = *entry.path;
    const Modes& current = reached.state;
    if (arrived(current, objective)) {
      PlannedStep& first = first_steps[reached.first];
      first.serves = served_by(modes, objective, first.component);
      return {std::move(first), excluded, current};
    }
    if (++settled > search_limit || space.tried > trial_limit) {
      otherwise.reason += "; the search for another way was given up after " + std::to_string(settled - 1) + " states";
      return {std::move(otherwise), excluded, {}, true};
    }
    NominalStep::Rest rest = nominal_.rest(current);
    Reliance reliance(*this, current, objective);
    for (const OffIdle& off : space.actions) {
      automata::ControlAction action = idle_;
      for (const auto& [control, value] : off) action[control] = value;
      // Idling comes first, and costs no more than what changes nothing.
      if (!off.empty() && !nominal_.matters(rest, off)) continue;
      ++space.tried;
      auto outcomes = nominal_.outcomes(current, action, objective.part, objective.permitted);
      if (!refused) refused = nominal_.refused();
      for (NominalOutcome& outcome : outcomes) {
        const bool risks = waits != Waits::any && !reliance.is_safe(action, outcome);
        if (risks || (waits == Waits::grounded && reliance.gives_up(outcome))) {
          excluded = true;
          continue;
        }
        if (!may_take(current, objective, action, outcome)) continue;
        Cost cost = reached.cost;
        if (!off.empty()) {
          cost.commands += 1;
          cost.late += cost.distance.steps;
        }
        // What has no part in the goal may do as it likes meanwhile.
        const auto moves = [&](auto&& suits) {
          return std::any_of(outcome.moves.begin(), outcome.moves.end(), [&](const NominalMove& move) {
            return space.involved[move.component.index()] && suits(move);
          });
        };
        cost.distance.steps += !off.empty() || moves([](const NominalMove&) { return true; }) ? 1 : 0;
        cost.delays += moves([](const NominalMove& move) { return move.transition->timed; }) ? 1 : 0;
        cost.cycles += 1;
        for (const NominalMove& move : outcome.moves) {
          const automata::ComponentId c = move.component;
          cost.losses += objective.wanted[c.index()] && !astray(current, objective, c) ? 1 : 0;
          cost.distance.irreversible += NominalGraph::harmless(*move.transition) ? 0 : 1;
        }
        std::size_t first = reached.first;
        if (first == none) {
          first = first_steps.size();
          const automata::ComponentId moved = moved_by(outcome, off.empty());
          first_steps.push_back({action, moved, moved, outcome, off.empty()});
        }
        offer(outcome.modes, cost, first);
      }
    }
  }
  if (refused && otherwise.why.obstacle == Reason::Obstacle::not_found) {
    otherwise.reason += "; what would lead on" + would_let(*refused);
    otherwise.why.obstacle = Reason::Obstacle::forbidden;
    otherwise.why.step = refused;
  }
  return {std::move(otherwise), excluded, {}};
}

}  // namespace rmpl::runtime
