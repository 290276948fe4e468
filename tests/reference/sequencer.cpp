// Step_THCA of thesis Fig. 5-3, its ten steps one after the other over sets.
// SPDX-License-Identifier: MIT
#include "tests/reference/sequencer.hpp"

#include <algorithm>

namespace rmpl::reference {

using automata::Assignment;
using automata::Location;
using automata::LocationId;

Sequencer::Sequencer(const automata::Program& program, const Models& models)
    : program_(program),
      models_(models),
      marking_(full_marking(LocationId(std::size_t{0}))),
      interpretation_(program.clocks.size()) {}

bool Sequencer::satisfied(const automata::Condition& condition, const std::vector<Assignment>& knowledge) const {
  return models_.entails(knowledge, known(condition.constraint), interpretation_) == condition.entailed;
}

automata::Formula Sequencer::known(const automata::Formula& formula) const {
  if (formula.kind == automata::Formula::Kind::knowledge) {
    return automata::constant(std::find(so_.begin(), so_.end(), formula) != so_.end());
  }
  automata::Formula result = formula;
  for (automata::Formula& operand : result.operands) operand = known(operand);
  return result;
}

bool Sequencer::achieved(LocationId location, const std::vector<Assignment>& knowledge) const {
  const auto& constraints = at(location).goal_constraints;
  return std::all_of(at(location).goal.begin(), at(location).goal.end(),
                     [&](Assignment goal) {
                       return models_.entails(knowledge, automata::is(goal.variable, goal.value), interpretation_);
                     }) &&
         std::all_of(constraints.begin(), constraints.end(), [&](const automata::Formula& constraint) {
           return models_.entails(knowledge, constraint, interpretation_);
         });
}

Sequencer::Locations Sequencer::subautomata(LocationId composite) const {
  Locations result;
  for (std::size_t i = 0; i < program_.locations.size(); ++i)
    for (auto ancestor = program_.locations[i].parent; ancestor; ancestor = at(*ancestor).parent)
      if (*ancestor == composite) result.insert(LocationId(i));
  return result;
}

Sequencer::Locations Sequencer::full_marking(LocationId location) const {
  Locations result = {location};
  for (std::size_t i = 0; i < program_.locations.size(); ++i)
    if (program_.locations[i].parent == location && program_.locations[i].start)
      result.merge(full_marking(LocationId(i)));
  return result;
}

std::vector<Sequencer::Goal> Sequencer::begin(const std::vector<Assignment>& knowledge, automata::Ticks now) {
  // 1. Update active clocks.
  interpretation_ = Clocks(program_.clocks.size());
  for (const auto& [clock, start] : started_) interpretation_[clock.index()] = now - start;

  // 2. Check maintenance constraints for marked composites.
  Locations unmarked;
  for (LocationId location : marking_)
    if (at(location).composite && !satisfied(at(location).maintenance, knowledge))
      unmarked.merge(subautomata(location));
  for (LocationId location : unmarked) marking_.erase(location);

  // 3. Assert clock initializations.
  started_next_.clear();
  for (LocationId location : marking_)
    if (const auto clock = at(location).clock_start; clock && !started_.contains(*clock)) started_next_[*clock] = now;

  // 4. Set up the configuration goal.
  violated_.clear();
  std::map<LocationId, Goal> goals;  // by the program or the branch
  goals[LocationId(std::size_t{0})];
  for (std::size_t i = 0; i < program_.locations.size(); ++i)
    if (program_.locations[i].apart) goals[LocationId(i)];
  for (LocationId location : marking_) {
    if (at(location).composite) continue;
    if (!satisfied(at(location).maintenance, knowledge)) {
      violated_.insert(location);
      continue;
    }
    LocationId owner = location;
    while (at(owner).parent && !at(owner).apart) owner = *at(owner).parent;
    Goal& goal = goals[owner];
    for (const automata::Formula& constraint : at(location).goal_constraints)
      if (std::find(goal.constraints.begin(), goal.constraints.end(), constraint) == goal.constraints.end())
        goal.constraints.push_back(constraint);
    for (Assignment assignment : at(location).goal) {
      for (Assignment other : goal.assignments)
        if (other.variable == assignment.variable && other.value != assignment.value) goal.contradictory = true;
      goal.assignments.insert(assignment);
    }
  }
  std::vector<Goal> result;
  for (auto& [owner, goal] : goals) result.push_back(std::move(goal));
  return result;
}

void Sequencer::finish(const std::vector<Assignment>& knowledge) {
  Locations next;
  Locations leaving;  // locations with an enabled outgoing transition
  Locations targets;
  const auto take_enabled = [&](LocationId location) {
    for (const automata::Arc& arc : at(location).arcs)
      if (satisfied(arc.guard, knowledge)) {
        leaving.insert(location);
        targets.insert(arc.target);
      }
  };

  // 7. Await incomplete goals. 8. Identify enabled transitions of primitive locations.
  for (LocationId location : marking_) {
    if (at(location).composite) continue;
    if (violated_.contains(location) || achieved(location, knowledge))
      take_enabled(location);
    else
      next.insert(location);
  }
  // 8. Of composite locations, innermost first: a child has a greater number than its parent.
  for (auto place = marking_.rbegin(); place != marking_.rend(); ++place) {
    if (!at(*place).composite) continue;
    const Locations inside = subautomata(*place);
    if (std::none_of(inside.begin(), inside.end(),
                     [&](LocationId i) { return next.contains(i) || leaving.contains(i); }))
      take_enabled(*place);
  }

  // 9. Take transitions; a composite stays marked while something inside it is.
  Locations newly_entered;
  for (LocationId target : targets) newly_entered.merge(full_marking(target));
  next.insert(newly_entered.begin(), newly_entered.end());
  Locations ancestors;
  for (LocationId location : next)
    for (auto parent = at(location).parent; parent; parent = at(*parent).parent) ancestors.insert(*parent);
  next.merge(ancestors);
  marking_ = std::move(next);

  // 10. Update the list of clock references.
  started_.merge(started_next_);
  for (LocationId entered : newly_entered)
    for (automata::ClockId clock : at(entered).own_clocks) started_.erase(clock);
}

}  // namespace rmpl::reference
