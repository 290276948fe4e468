// One cycle of a THCA: Fig. 5-3, step by step.
// SPDX-License-Identifier: MIT
#include "automata/step/program_rules.hpp"

#include <map>
#include <utility>

#include "base/check.hpp"

namespace rmpl::automata {
namespace {

Marking listed(const std::vector<bool>& marked) {
  Marking result;
  for (std::size_t l = 0; l < marked.size(); ++l) {
    if (marked[l]) result.emplace_back(l);
  }
  return result;
}

}  // namespace

ProgramRules::ProgramRules(const Program& program) : program_(program), children_(program.locations.size()) {
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    const auto& parent = program_.locations[l].parent;
    if (!parent) continue;
    CHECK(parent->index() < l && "a child comes after its parent");
    children_[parent->index()].emplace_back(l);
  }
}

Marking ProgramRules::initial() const {
  std::vector<bool> marked(program_.locations.size(), false);
  if (!marked.empty()) mark_fully(LocationId(0), marked);
  return listed(marked);
}

/// m_F: the location and, recursively, the start locations of what it holds.
void ProgramRules::mark_fully(LocationId location, std::vector<bool>& marked) const {
  marked[location.index()] = true;
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
  for (const LocationId id : marking) {
    half.working[id.index()] = true;
    half.violated[id.index()] = !answers.maintained(id);
  }
  std::vector<bool> inside_violated(locations.size(), false);
  for (std::size_t l = 0; l < locations.size(); ++l) {
    if (!locations[l].parent) continue;
    const std::size_t parent = locations[l].parent->index();
    inside_violated[l] = inside_violated[parent] || (half.violated[parent] && locations[parent].composite);
    if (inside_violated[l]) half.working[l] = false;
  }
  // 3. Assert clock initialisations; a clock that runs already keeps its start (step 10 adds it back).
  half.started = started;
  // 4. Set up the configuration goal.
  asserted.goal.clear();
  asserted.by.clear();
  asserted.conflicts.clear();
  std::map<VariableId, std::pair<ValueId, LocationId>> goals;
  for (const LocationId id : marking) {
    const Location& location = locations[id.index()];
    if (!half.working[id.index()] || location.composite) continue;
    if (location.clock_start && !half.started[location.clock_start->index()]) {
      half.started[location.clock_start->index()] = now;
    }
    if (half.violated[id.index()]) continue;
    for (const Assignment& goal : location.goal) {
      const auto [at, fresh] = goals.try_emplace(goal.variable, goal.value, id);
      if (!fresh && at->second.first != goal.value) {
        asserted.conflicts.push_back({at->second.second, id, goal, {goal.variable, at->second.first}});
      }
    }
  }
  for (const auto& [variable, goal] : goals) {
    asserted.goal.push_back({variable, goal.first});
    asserted.by.push_back(goal.second);
  }
}

void ProgramRules::stop_own_clocks(LocationId entered, ClockTimes& started) const {
  for (const ClockId clock : program_.locations[entered.index()].own_clocks) started[clock.index()].reset();
  for (const LocationId child : children_[entered.index()]) {
    if (program_.locations[child.index()].start) stop_own_clocks(child, started);
  }
}

Marking ProgramRules::finish(const HalfCycle& half, ProgramAnswers& answers, ClockTimes& started) const {
  const auto& locations = program_.locations;
  std::vector<bool> next(locations.size(), false);
  std::vector<bool> leaves(locations.size(), false);  // has an enabled outgoing transition
  std::vector<LocationId> targets;
  const auto take = [&](std::size_t l) {
    for (std::size_t a = 0; a < locations[l].arcs.size(); ++a) {
      if (!answers.guard_holds(LocationId(l), a)) continue;
      leaves[l] = true;
      targets.push_back(locations[l].arcs[a].target);
    }
  };
  // 7. Await incomplete goals; 8. enabled transitions of primitive locations.
  for (std::size_t l = 0; l < locations.size(); ++l) {
    if (!half.working[l] || locations[l].composite) continue;
    const bool reached = locations[l].goal.empty() || answers.achieved(LocationId(l));
    if (!reached && !half.violated[l]) next[l] = true;
    if (reached || half.violated[l]) take(l);
  }
  // 8. Composite locations, from the inside out: children come after their parents.
  std::vector<bool> busy(locations.size(), false);  // some subautomaton goes on or leaves
  for (std::size_t l = locations.size(); l-- > 0;) {
    if (locations[l].composite && half.working[l] && !busy[l]) take(l);
    if (locations[l].parent && (busy[l] || next[l] || leaves[l])) busy[locations[l].parent->index()] = true;
  }
  // 9. Take transitions; re-mark the composites that hold a marked location.
  for (const LocationId target : targets) mark_fully(target, next);
  for (std::size_t l = locations.size(); l-- > 0;) {
    if (next[l] && locations[l].parent) next[locations[l].parent->index()] = true;
  }
  // 10. Update the list of clock references. An activation finds the clocks that are its own inactive.
  started = half.started;
  for (const LocationId target : targets) stop_own_clocks(target, started);
  return listed(next);
}

}  // namespace rmpl::automata
