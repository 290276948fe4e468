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

/// A path to a state: how long it is, and the step that it begins with.
struct Path {
  Distance distance;
  std::size_t first;  ///< position among the first steps; `none` for the start
  bool settled = false;
};
constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Best paths first; of equal ones that which was found first, so that ties go by the order of actions.
struct Entry {
  Distance distance;
  std::size_t found;
  const Modes* modes;
  bool operator>(const Entry& other) const { return std::tie(distance, found) > std::tie(other.distance, other.found); }
};

}  // namespace

std::vector<Planner::OffIdle> Planner::promising(const Modes& modes, const Objective& objective) {
  std::vector<bool> involved(modes.size());
  std::vector<bool> useful(nominal_.plant().variables.size());
  std::vector<automata::ComponentId> open;
  const auto involve = [&](automata::ComponentId c) {
    if (involved[c.index()]) return;
    involved[c.index()] = true;
    open.push_back(c);
  };
  for (const automata::ComponentId c : parts_.components(objective.part)) {
    if (astray(modes, objective, c)) involve(c);
  }
  while (!open.empty()) {
    const automata::ComponentId c = open.back();
    open.pop_back();
    for (const NominalTransition& t : graph_.transitions(c)) {
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          useful[r.variable.index()] = true;
          if (const auto upstream = index_.component_of(r.variable)) involve(*upstream);
        }
      }
    }
  }
  std::vector<OffIdle> some;
  const auto& controls = nominal_.plant().controls;
  const auto& all = actions(objective.part);
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), [&](const OffIdle& action) {
    return std::all_of(action.begin(), action.end(),
                       [&](const auto& off) { return useful[controls[off.first].variable.index()]; });
  });
  return some;
}

/// Promising actions first; where they do not get there, all.
Planner::Found Planner::search(const Modes& modes, const Objective& objective, const Impasse& otherwise, Waits waits) {
  const auto& all = actions(objective.part);
  const std::vector<OffIdle> some = promising(modes, objective);
  Found found = search(modes, objective, otherwise, waits, some);
  if (std::holds_alternative<PlannedStep>(found.first) || some.size() == all.size()) return found;
  return search(modes, objective, otherwise, waits, all);
}

/// Uniform-cost search over the nominal successors of the whole part: fewest irreversible steps, then fewest steps.
/// The same rules on irreversible steps hold; what is achieved may be undone on the path.
Planner::Found Planner::search(const Modes& modes, const Objective& objective, Impasse otherwise, Waits waits,
                               std::span<const OffIdle> actions) {
  const auto& components = ordered_[objective.part];
  const automata::ComponentId served =
      *std::find_if(components.begin(), components.end(), [&](auto c) { return astray(modes, objective, c); });
  bool excluded = false;
  std::unordered_map<Modes, Path, automata::ModesHash> paths;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<PlannedStep> first_steps;
  std::size_t found = 0;
  std::size_t settled = 0;
  const auto offer = [&](const Modes& state, Distance distance, std::size_t first) {
    const auto [at, fresh] = paths.try_emplace(state, Path{distance, first});
    if (!fresh && (at->second.settled || at->second.distance <= distance)) return;
    at->second = Path{distance, first};
    open.push({distance, found++, &at->first});
  };
  offer(modes, {}, none);
  while (!open.empty()) {
    const Entry entry = open.top();
    open.pop();
    Path& path = paths.at(*entry.modes);
    if (path.settled) continue;
    path.settled = true;
    const Modes current = *entry.modes;
    const Path reached = path;
    if (arrived(current, objective)) return {std::move(first_steps[reached.first]), excluded, current};
    if (++settled > search_limit || tried_ > trial_limit) {
      otherwise.reason += "; the search for another way was given up after " + std::to_string(settled - 1) + " states";
      return {std::move(otherwise), excluded, {}};
    }
    tried_ += actions.size();
    for (const OffIdle& off : actions) {
      automata::ControlAction action = idle_;
      for (const auto& [control, value] : off) action[control] = value;
      for (NominalOutcome& outcome : nominal_.outcomes(current, action, objective.part, objective.permitted)) {
        if (waits == Waits::safe && !is_safe(current, objective, action, outcome)) {
          excluded = true;
          continue;
        }
        if (!may_take(current, objective, off.empty(), outcome)) continue;
        Distance distance = reached.distance + Distance{0, 1};
        for (const NominalMove& move : outcome.moves) {
          distance.irreversible += NominalGraph::harmless(*move.transition) ? 0 : 1;
        }
        std::size_t first = reached.first;
        if (first == none) {
          first = first_steps.size();
          first_steps.push_back({action, outcome.moves.front().component, served, outcome, off.empty()});
        }
        offer(outcome.modes, distance, first);
      }
    }
  }
  return {std::move(otherwise), excluded, {}};
}

}  // namespace rmpl::runtime
