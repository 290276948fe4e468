// Goals that commands do not reach, or that cannot be undone.
// SPDX-License-Identifier: MIT
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "automata/assignment_text.hpp"
#include "compiler/check/vocabulary.hpp"
#include "compiler/lint/program/bound_programs.hpp"
#include "compiler/lint/program/passes.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::Component;
using automata::ModeId;
using grammar::Code;

namespace {

/// Calls `visit(location, goal, component)` for each mode of a plant's component that a program asks for.
void for_each_goal(const BoundProgram& bound, const auto& visit) {
  if (bound.plant == nullptr) return;
  for (std::size_t l = 0; l < bound.program.locations.size(); ++l) {
    for (const Assignment& goal : bound.program.locations[l].goal) {
      if (const auto id = bound.plant->component_of(goal.variable)) {
        visit(automata::LocationId(l), goal, (*bound.plant)[*id]);
      }
    }
  }
}

std::string text_of(const BoundProgram& bound, const Assignment& goal) {
  return backquoted(to_text(bound.plant->variables, goal));
}

/// The modes that nominal transitions lead to from some modes.
std::vector<bool> nominal_closure(const Component& component, std::vector<bool> from) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const automata::Transition& transition : component.transitions) {
      if (component.is_fault(transition) || !from[transition.from.index()] || from[transition.to.index()]) continue;
      from[transition.to.index()] = changed = true;
    }
  }
  return from;
}

std::vector<bool> nominal_closure(const Component& component, ModeId from) {
  std::vector<bool> modes(component.modes.size(), false);
  modes[from.index()] = true;
  return nominal_closure(component, std::move(modes));
}

/// The transition that cannot be undone and that every nominal way from the initial modes to this one takes one like;
/// nothing where there is a way back from the mode to where it came from, or no way at all.
std::optional<automata::Transition> point_of_no_return(const Component& component, ModeId mode) {
  std::vector<bool> start(component.modes.size(), false);
  for (std::size_t m = 0; m < start.size(); ++m) start[m] = component.initial[m] > 0;
  if (!nominal_closure(component, start)[mode.index()]) return std::nullopt;
  // One that starts in a mode that this one leads back to is undone by going round.
  const std::vector<bool> back = nominal_closure(component, mode);
  for (std::size_t m = 0; m < start.size(); ++m) {
    if (start[m] && back[m] && nominal_closure(component, ModeId(m))[mode.index()]) return std::nullopt;
  }
  for (const automata::Transition& transition : component.transitions) {
    const bool enters = !component.is_fault(transition) && !back[transition.from.index()] &&
                        nominal_closure(component, transition.to)[mode.index()] && back[transition.to.index()];
    if (enters) return transition;
  }
  return std::nullopt;
}

}  // namespace

void lint_fault_goals(const LintInput& input, grammar::Diagnostics& found) {
  std::set<std::pair<grammar::Span, Assignment>> told;
  for (const BoundProgram& bound : bound_programs(input)) {
    for_each_goal(bound, [&](automata::LocationId location, const Assignment& goal, const Component& component) {
      const automata::Mode& mode = component.modes[goal.value.index()];
      const grammar::Span span = span_of(input, bound, location);
      if (!mode.fault || !told.insert({span, goal}).second) return;
      auto& finding = add_finding(found, Code::goal_on_fault_mode, span,
                                  text_of(bound, goal) + " is a goal, but no command leads into a fault mode");
      finding.notes.push_back({input.places.at(mode.origin), backquoted(mode.name) + " is a fault mode"});
      finding.suggestion = "to wait for the fault, write `when " + to_text(bound.plant->variables, goal) + " donext …`";
    });
  }
}

void lint_irreversible_goals(const LintInput& input, grammar::Diagnostics& found) {
  std::set<std::pair<grammar::Span, Assignment>> told;
  for (const BoundProgram& bound : bound_programs(input)) {
    std::map<Assignment, std::optional<automata::Transition>> known;
    for_each_goal(bound, [&](automata::LocationId location, const Assignment& goal, const Component& component) {
      if (component.progress) return;  // it is meant to
      auto step = known.find(goal);
      if (step == known.end()) {
        step = known.emplace(goal, point_of_no_return(component, ModeId(goal.value.index()))).first;
      }
      const grammar::Span span = span_of(input, bound, location);
      if (!step->second || !told.insert({span, goal}).second) return;
      auto& finding = add_finding(found, Code::irreversible_goal, span,
                                  text_of(bound, goal) + " is only reached by an irreversible step");
      finding.notes.push_back({input.places.at(step->second->origin),
                               "no nominal transitions lead back from " +
                                   backquoted(component.modes[step->second->to.index()].name) + " to " +
                                   backquoted(component.modes[step->second->from.index()].name)});
    });
  }
}

}  // namespace rmpl::compiler
