// What of a goal may be lost by itself.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/upkeep.hpp"

#include <algorithm>

#include "base/product.hpp"
#include "runtime/reasoning/reconfigure/least_ways.hpp"

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

namespace {

/// Combinations of modes that are asked about; beyond, what the goal leaves to entailment counts as lost.
constexpr std::size_t most_combinations = 64;

}  // namespace

Upkeep::Upkeep(automata::PlantStep& step, const NominalGraph& graph, const Goal& goal)
    : step_(step), graph_(graph), goal_(goal), drift_(step.plant().components.size()) {
  for (std::size_t c = 0; c < drift_.size(); ++c) {
    if (goal.restricts(ComponentId(c))) restricted_.emplace_back(c);
  }
  if (goal.rest()) support_ = step.locality().support_of(goal.rest()->formula).components;
  std::vector<ComponentId> decisive = restricted_;
  decisive.insert(decisive.end(), support_.begin(), support_.end());
  involved_ = graph.upstream(decisive);
}

void Upkeep::follow(const Modes& modes, Soon soon) {
  for (const ComponentId c : involved_) {
    drift_[c.index()].assign(step_.plant()[c].modes.size(), false);
    drift_[c.index()][modes[c.index()].index()] = true;
  }
  if (soon != Soon::next) return drift(graph_, drift_, involved_, soon == Soon::ever ? Drift::any : Drift::untimed);
  const Reached now = drift_;
  for (const ComponentId c : involved_) {
    for (const NominalTransition& t : graph_.transitions(c)) {
      if (t.from == modes[c.index()] && t.possible && comes_by_itself(graph_, t, now)) {
        drift_[c.index()][t.to.index()] = true;
      }
    }
  }
}

/// Whether some of the modes that the components may come to leave the rest of the goal open.
bool Upkeep::rest_may_fail() {
  std::vector<std::vector<automata::Assignment>> options;
  std::size_t count = 1;
  for (const ComponentId c : support_) {
    auto& reached = options.emplace_back();
    for (std::size_t m = 0; m < drift_[c.index()].size(); ++m) {
      if (drift_[c.index()][m]) reached.push_back({step_.plant()[c].mode, automata::ValueId(m)});
    }
    count *= reached.size();
    if (count > most_combinations) return true;
  }
  bool fails = false;
  base::for_each_combination(options, [&](const std::vector<automata::Assignment>& store) {
    fails = fails || !step_.theory().entails(store, goal_.rest()->holds);
  });
  return fails;
}

std::vector<bool> Upkeep::had(const Modes& modes) {
  std::vector<bool> result;
  for (const ComponentId c : restricted_) result.push_back(goal_.permits(c, modes[c.index()]));
  if (goal_.rest()) {
    result.push_back(step_.theory().entails(assignments_of(step_.plant(), modes), goal_.rest()->holds));
  }
  return result;
}

std::vector<Upkeep::Soon> Upkeep::loss(const Modes& modes, base::FunctionRef<void()> followed) {
  std::vector<Soon> result(restricted_.size() + (goal_.rest() ? 1 : 0), Soon::never);
  for (const Soon soon : soons) {
    follow(modes, soon);
    followed();
    const std::vector<bool> lost = losable();
    for (std::size_t part = 0; part < result.size(); ++part) {
      if (lost[part]) result[part] = soon;
    }
  }
  return result;
}

std::vector<bool> Upkeep::losable() {
  std::vector<bool> result;
  for (const ComponentId c : restricted_) {
    const auto& reached = drift_[c.index()];
    bool lost = false;
    for (std::size_t m = 0; m < reached.size(); ++m) {
      lost = lost || (reached[m] && !goal_.permits(c, automata::ModeId(m)));
    }
    result.push_back(lost);
  }
  if (goal_.rest()) result.push_back(rest_may_fail());
  return result;
}

Upkeep::Standing Upkeep::standing(const Modes& modes) {
  Standing standing{had(modes), {}, {}};
  standing.loss = loss(modes, [&] { standing.drift.push_back(drift_); });
  return standing;
}

std::vector<std::size_t> Upkeep::steps_to(ComponentId component, automata::ModeId aim) const {
  const auto& transitions = graph_.transitions(component);
  const auto one = [](const NominalTransition& t) { return t.possible ? std::optional<std::size_t>(1) : std::nullopt; };
  std::vector<std::size_t> steps;
  for (const auto& way : least_ways<std::size_t>(transitions, drift_[component.index()].size(), aim, one)) {
    steps.push_back(way.cost.value_or(transitions.size() + 1));
  }
  return steps;
}

bool Upkeep::leaves(const std::vector<bool>& some, const Standing& before, const Modes& after, const Modes& target) {
  for (std::size_t i = 0; i < soons.size(); ++i) {
    follow(after, soons[i]);
    const bool left = std::all_of(involved_.begin(), involved_.end(), [&](ComponentId c) {
      return !some[c.index()] || no_farther(c, before.drift[i][c.index()], after[c.index()], target[c.index()]);
    });
    if (!left) return false;
  }
  return true;
}

/// Whether what the component can come to has its aim where it had, and is no farther from there than it is now where
/// it is new.
bool Upkeep::no_farther(ComponentId component, const std::vector<bool>& could, automata::ModeId now,
                        automata::ModeId aim) const {
  const std::vector<bool>& can = drift_[component.index()];
  if (could[aim.index()] && !can[aim.index()]) return false;
  const std::vector<std::size_t> steps = steps_to(component, aim);
  for (std::size_t m = 0; m < can.size(); ++m) {
    if (can[m] && !could[m] && steps[m] > steps[now.index()]) return false;
  }
  return true;
}

bool Upkeep::keeps(const Standing& before, const Modes& after) {
  const std::vector<bool> now = had(after);
  for (std::size_t part = 0; part < now.size(); ++part) {
    if (before.had[part] && !now[part]) return false;
  }
  const std::vector<Soon> then = loss(after, [] {});
  for (std::size_t part = 0; part < then.size(); ++part) {
    if (before.had[part] && then[part] > before.loss[part]) return false;
  }
  return true;
}

}  // namespace rmpl::runtime
