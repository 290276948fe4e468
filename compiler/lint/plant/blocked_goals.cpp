// Finding: goals that cannot be brought about any more once a fault has happened.
//
// The component is kept to the modes that nominal transitions lead to from the fault, the others to those that they
// reach. Then nothing implies the guard of any transition that leads to the goal, whatever is commanded; so the goal is
// kept at most where it was reached before. One step back is looked at: what stands further off may have come before
// the fault did. SPDX-License-Identifier: MIT
#include <algorithm>

#include "compiler/lint/plant/findings.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ComponentId;
using automata::ModeId;
using automata::Support;
using automata::Transition;
using automata::ValueId;

namespace {

class BlockedGoals {
 public:
  explicit BlockedGoals(PlantAnalysis& analysis) : analysis_(analysis) {}

  std::vector<BlockedGoal> run(const std::vector<PlantMode>& goals) {
    std::vector<Way> ways;
    ways.reserve(goals.size());
    for (const PlantMode& goal : goals) ways.push_back(way_to(goal));
    std::vector<BlockedGoal> found;
    for (std::size_t c = 0; c < plant().components.size(); ++c) {
      const Component& component = plant().components[c];
      for (std::size_t m = 0; m < component.modes.size() && patience_ > 0; ++m) {
        if (!component.modes[m].fault || !analysis_.reach().reached[c][m]) continue;
        look_at({ComponentId(c), ModeId(m)}, ways, found);
      }
    }
    analysis_.questions().keep_to(analysis_.reach().reached);
    return found;
  }

 private:
  /// A goal with the transitions that lead there from other modes, and what these and the goal itself depend on.
  struct Way {
    PlantMode goal;
    std::vector<const Transition*> transitions;
    Support support;
  };

  [[nodiscard]] const automata::Plant& plant() const { return analysis_.plant(); }

  Way way_to(PlantMode goal) const {
    Way way{goal, {}, {{goal.component}, {}}};
    const Component& component = plant()[goal.component];
    way.support.join(analysis_.locality().support_of(component.modes[goal.mode.index()].constraint));
    for (std::size_t t = 0; t < component.transitions.size(); ++t) {
      const Transition& transition = component.transitions[t];
      if (transition.to != goal.mode || transition.from == goal.mode || component.is_fault(transition)) continue;
      if (!analysis_.can_happen({goal.component, automata::TransitionId(t)})) continue;
      way.transitions.push_back(&transition);
      way.support.join(analysis_.locality().support_of(transition.guard));
    }
    return way;
  }

  /// The modes that nominal transitions lead to from the fault, it among them.
  [[nodiscard]] std::vector<bool> after(PlantMode fault) const {
    const Component& component = plant()[fault.component];
    std::vector<bool> result(component.modes.size());
    std::vector<ModeId> pending{fault.mode};
    result[fault.mode.index()] = true;
    while (!pending.empty()) {
      const ModeId from = pending.back();
      pending.pop_back();
      for (std::size_t t = 0; t < component.transitions.size(); ++t) {
        const Transition& way = component.transitions[t];
        if (way.from != from || result[way.to.index()] || component.is_fault(way)) continue;
        if (!analysis_.can_happen({fault.component, automata::TransitionId(t)})) continue;
        result[way.to.index()] = true;
        pending.push_back(way.to);
      }
    }
    return result;
  }

  void look_at(PlantMode fault, const std::vector<Way>& ways, std::vector<BlockedGoal>& found) {
    const std::vector<bool> kept = after(fault);
    bool asked = false;
    for (const Way& way : ways) {
      if (way.transitions.empty() || !way.support.reads(fault.component)) continue;
      if (way.goal.component == fault.component) {
        if (!kept[way.goal.mode.index()]) found.push_back({fault, way.goal});
        continue;
      }
      if (!asked) {
        ModeSets modes = analysis_.reach().reached;
        modes[fault.component.index()] = kept;
        analysis_.questions().keep_to(modes);
        asked = true;
      }
      if (is_blocked(way)) found.push_back({fault, way.goal});
    }
  }

  /// With the components as they are kept.
  bool is_blocked(const Way& way) {
    const Component& component = plant()[way.goal.component];
    const Assignment goal{component.mode, ValueId(way.goal.mode.index())};
    if (patience_ == 0) return false;
    --patience_;
    if (!analysis_.questions().possible({&goal, 1})) return true;
    return std::all_of(way.transitions.begin(), way.transitions.end(), [&](const Transition* transition) {
      if (patience_ == 0) return false;
      --patience_;
      const automata::Formula* guard = &transition->guard;
      return analysis_.questions().implied(way.goal.component, transition->from, {&guard, 1}).verdict ==
             Implied::Verdict::no;
    });
  }

  PlantAnalysis& analysis_;
  std::size_t patience_ = 300;  ///< questions; what was not asked is not told
};

}  // namespace

std::vector<BlockedGoal> find_blocked_goals(PlantAnalysis& analysis, const std::vector<PlantMode>& goals) {
  // Each question is about the whole plant, with sets of modes: in larger ones a single one may take seconds.
  constexpr std::size_t most_components = 32;
  if (analysis.plant().components.size() > most_components) return {};
  return BlockedGoals(analysis).run(goals);
}

}  // namespace rmpl::compiler
