// One cycle of a THCA: Fig. 5-3, step by step.
// SPDX-License-Identifier: MIT
#include "automata/step/program_rules.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/check.hpp"

namespace rmpl::automata {

/// Locations, each once, in the order in which they are marked.
class ProgramRules::Marked {
 public:
  explicit Marked(std::size_t locations) : marked_(locations, false) {}

  void add(LocationId location) {
    if (marked_[location.index()]) return;
    marked_[location.index()] = true;
    listed_.push_back(location);
  }
  [[nodiscard]] const Marking& listed() const { return listed_; }
  [[nodiscard]] Marking sorted() && {
    std::sort(listed_.begin(), listed_.end());
    return std::move(listed_);
  }

 private:
  std::vector<bool> marked_;
  Marking listed_;
};

ProgramRules::ProgramRules(const Program& program)
    : program_(program),
      children_(program.locations.size()),
      parts_(goal_parts_of(program)),
      branches_(parts_.empty() ? 0 : *std::max_element(parts_.begin(), parts_.end())) {
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    const auto& parent = program_.locations[l].parent;
    if (!parent) continue;
    CHECK(parent->index() < l && "a child comes after its parent");
    children_[parent->index()].emplace_back(l);
  }
}

Formula Goals::formula() const {
  std::vector<Formula> conjuncts;
  for (const Assignment& assigned : goal) conjuncts.push_back(is(assigned.variable, assigned.value));
  for (const GoalConstraint& constraint : constraints) conjuncts.push_back(constraint.formula);
  return conjunction(std::move(conjuncts));
}

namespace {

/// Adds a constraint that is not yet among them.
void add(std::vector<GoalConstraint>& constraints, const Formula& formula, LocationId by) {
  const auto known = std::find_if(constraints.begin(), constraints.end(),
                                  [&](const GoalConstraint& other) { return other.formula == formula; });
  if (known == constraints.end()) constraints.push_back({formula, by});
}

}  // namespace

Goals together(std::span<const Goals> several) {
  if (several.size() == 1) return several.front();
  std::map<Assignment, LocationId> goals;
  Goals all;
  for (const Goals& one : several) {
    for (std::size_t g = 0; g < one.goal.size(); ++g) goals.emplace(one.goal[g], one.by[g]);
    for (const GoalConstraint& constraint : one.constraints) add(all.constraints, constraint.formula, constraint.by);
  }
  for (const auto& [assigned, by] : goals) {
    all.goal.push_back(assigned);
    all.by.push_back(by);
  }
  return all;
}

Marking ProgramRules::initial() const {
  Marked marked(program_.locations.size());
  if (!program_.locations.empty()) mark_fully(LocationId(0), marked);
  return std::move(marked).sorted();
}

/// m_F: the location and, recursively, the start locations of what it holds.
void ProgramRules::mark_fully(LocationId location, Marked& marked) const {
  marked.add(location);
  for (const LocationId child : children_[location.index()]) {
    if (program_.locations[child.index()].start) mark_fully(child, marked);
  }
}

// 1. Update active clocks.
ClockTimes ProgramRules::readings(const ClockTimes& started, Ticks now) {
  ClockTimes result(started.size());
  for (std::size_t c = 0; c < started.size(); ++c) {
    if (started[c]) result[c] = now - *started[c];
  }
  return result;
}

void ProgramRules::begin(const Marking& marking, const ClockTimes& started, Ticks now, ProgramAnswers& answers,
                         HalfCycle& half, Asserted& asserted) const {
  const auto& locations = program_.locations;
  // 2. Check maintenance constraints: everything inside a violated composite is unmarked; the composite itself stays.
  // Violations are judged on m(i), before any unmarking. Parents come first, so one pass hands `unmarked` down.
  half.working.assign(locations.size(), false);
  half.violated.assign(locations.size(), false);
  half.marking.clear();
  for (const LocationId id : marking) half.violated[id.index()] = !answers.maintained(id);
  for (const LocationId id : marking) {
    const auto& parent = locations[id.index()].parent;
    if (parent && (!half.working[parent->index()] || half.violated[parent->index()])) continue;
    half.working[id.index()] = true;
    half.marking.push_back(id);
  }
  // 3. Assert clock initialisations; a clock that runs already keeps its start (step 10 adds it back).
  half.started = started;
  // 4. Set up the configuration goal.
  asserted.goal.clear();
  asserted.by.clear();
  asserted.constraints.clear();
  asserted.conflicts.clear();
  asserted.branches.assign(branches_, {});
  std::map<std::pair<std::size_t, VariableId>, std::pair<ValueId, LocationId>> goals;
  const auto of_part = [&](std::size_t part) -> Goals& { return part == 0 ? asserted : asserted.branches[part - 1]; };
  for (const LocationId id : half.marking) {
    const Location& location = locations[id.index()];
    if (location.composite) continue;
    if (location.clock_start && !half.started[location.clock_start->index()]) {
      half.started[location.clock_start->index()] = now;
    }
    if (half.violated[id.index()]) continue;
    const std::size_t part = parts_[id.index()];
    for (const Assignment& goal : location.goal) {
      const auto [at, fresh] = goals.try_emplace({part, goal.variable}, goal.value, id);
      if (!fresh && at->second.first != goal.value) {
        asserted.conflicts.push_back({at->second.second, id, goal, {goal.variable, at->second.first}});
      }
    }
    for (const Formula& constraint : location.goal_constraints) add(of_part(part).constraints, constraint, id);
  }
  for (const auto& [asked, goal] : goals) {
    Goals& part = of_part(asked.first);
    part.goal.push_back({asked.second, goal.first});
    part.by.push_back(goal.second);
  }
  std::erase_if(asserted.branches, [](const Goals& branch) { return branch.empty(); });
}

void ProgramRules::stop_own_clocks(LocationId entered, ClockTimes& started) const {
  for (const ClockId clock : program_.locations[entered.index()].own_clocks) started[clock.index()].reset();
  for (const LocationId child : children_[entered.index()]) {
    if (program_.locations[child.index()].start) stop_own_clocks(child, started);
  }
}

Marking ProgramRules::finish(const HalfCycle& half, ProgramAnswers& answers, ClockTimes& started) const {
  const auto& locations = program_.locations;
  Marked next(locations.size());
  std::vector<bool> busy(locations.size(), false);  // composites of which some subautomaton goes on or leaves
  std::vector<LocationId> targets;
  const auto takes = [&](LocationId id) {
    const auto& arcs = locations[id.index()].arcs;
    bool leaves = false;
    for (std::size_t a = 0; a < arcs.size(); ++a) {
      if (!answers.guard_holds(id, a)) continue;
      leaves = true;
      targets.push_back(arcs[a].target);
    }
    return leaves;
  };
  // 7. Await incomplete goals; 8. enabled transitions, from the inside out: children come after their parents.
  for (auto at = half.marking.rbegin(); at != half.marking.rend(); ++at) {
    const Location& location = locations[at->index()];
    const bool awaits =
        !location.composite && !half.violated[at->index()] && location.has_goal() && !answers.achieved(*at);
    if (awaits) next.add(*at);
    const bool goes_on = awaits || busy[at->index()];
    if ((goes_on || takes(*at)) && location.parent) busy[location.parent->index()] = true;
  }
  // 9. Take transitions; re-mark the composites that hold a marked location.
  for (const LocationId target : targets) mark_fully(target, next);
  for (std::size_t i = 0; i < next.listed().size(); ++i) {
    if (const auto& parent = locations[next.listed()[i].index()].parent) next.add(*parent);
  }
  // 10. Update the list of clock references. An activation finds the clocks that are its own inactive.
  started = half.started;
  for (const LocationId target : targets) stop_own_clocks(target, started);
  return std::move(next).sorted();
}

}  // namespace rmpl::automata
