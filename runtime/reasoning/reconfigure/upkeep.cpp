// What of a goal may be lost by itself.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/reconfigure/upkeep.hpp"

#include <algorithm>

namespace rmpl::runtime {

using automata::ComponentId;
using automata::Modes;

namespace {

/// Combinations of modes that are asked about; beyond, what the goal leaves to entailment counts as lost.
constexpr std::size_t most_combinations = 64;

}  // namespace

Upkeep::Upkeep(automata::PlantStep& step, const NominalGraph& graph, const Goal& goal)
    : step_(step), graph_(graph), goal_(goal), drift_(step.plant().components.size()) {
  std::vector<bool> known(drift_.size());
  const auto involve = [&](ComponentId c) {
    if (known[c.index()]) return;
    known[c.index()] = true;
    involved_.push_back(c);
  };
  for (std::size_t c = 0; c < drift_.size(); ++c) {
    if (goal.restricts(ComponentId(c))) restricted_.emplace_back(c);
  }
  if (goal.rest()) support_ = step.locality().support_of(goal.rest()->formula).components;
  for (const ComponentId c : restricted_) involve(c);
  for (const ComponentId c : support_) involve(c);
  for (std::size_t next = 0; next < involved_.size(); ++next) {
    for (const NominalTransition& t : graph.transitions(involved_[next])) {
      for (const Precondition& precondition : t.preconditions) {
        for (const Requirement& r : precondition) {
          if (const auto upstream = graph.component_of(r)) involve(*upstream);
        }
      }
    }
  }
}

void Upkeep::follow(const Modes& modes) {
  for (const ComponentId c : involved_) {
    drift_[c.index()].assign(step_.plant()[c].modes.size(), false);
    drift_[c.index()][modes[c.index()].index()] = true;
  }
  const auto comes_by_itself = [&](const NominalTransition& t) {
    for (std::size_t p = 0; p < t.preconditions.size(); ++p) {
      const Precondition& precondition = t.preconditions[p];
      if (t.silent[p] && std::all_of(precondition.begin(), precondition.end(),
                                     [&](const Requirement& r) { return graph_.meets(r, drift_); })) {
        return true;
      }
    }
    return false;
  };
  for (bool more = true; more;) {
    more = false;
    for (const ComponentId c : involved_) {
      auto& reached = drift_[c.index()];
      for (const NominalTransition& t : graph_.transitions(c)) {
        if (!reached[t.from.index()] || reached[t.to.index()] || !t.possible || !comes_by_itself(t)) continue;
        reached[t.to.index()] = more = true;
      }
    }
  }
}

/// Whether some of the modes that the components may come to leave the rest of the goal open.
bool Upkeep::may_fail(const Modes& modes) {
  std::vector<std::vector<std::size_t>> options;
  std::size_t count = 1;
  for (const ComponentId c : support_) {
    auto& reached = options.emplace_back();
    for (std::size_t m = 0; m < drift_[c.index()].size(); ++m) {
      if (drift_[c.index()][m]) reached.push_back(m);
    }
    count *= reached.size();
    if (count > most_combinations) return true;
  }
  std::vector<automata::Assignment> store;
  for (const ComponentId c : support_) {
    store.push_back({step_.plant()[c].mode, automata::ValueId(modes[c.index()].index())});
  }
  for (std::size_t number = 0; number < count; ++number) {
    std::size_t left = number;
    for (std::size_t i = 0; i < options.size(); ++i) {
      store[i].value = automata::ValueId(options[i][left % options[i].size()]);
      left /= options[i].size();
    }
    if (!step_.theory().entails(store, goal_.rest()->holds)) return true;
  }
  return false;
}

Upkeep::Standing Upkeep::standing(const Modes& modes) {
  follow(modes);
  Standing result;
  for (const ComponentId c : restricted_) {
    const auto& reached = drift_[c.index()];
    bool lost = false;
    for (std::size_t m = 0; m < reached.size(); ++m) {
      lost = lost || (reached[m] && !goal_.permits(c, automata::ModeId(m)));
    }
    result.had.push_back(goal_.permits(c, modes[c.index()]));
    result.losable.push_back(lost);
  }
  if (goal_.rest()) {
    result.had.push_back(step_.theory().entails(assignments_of(step_.plant(), modes), goal_.rest()->holds));
    result.losable.push_back(result.had.back() && may_fail(modes));
  }
  return result;
}

bool Upkeep::keeps(const Standing& before, const Modes& after) {
  const Standing now = standing(after);
  for (std::size_t part = 0; part < now.had.size(); ++part) {
    if (before.had[part] && (!now.had[part] || (now.losable[part] && !before.losable[part]))) return false;
  }
  return true;
}

}  // namespace rmpl::runtime
