// One step of a THCA: Fig. 5-3, step by step.
// SPDX-License-Identifier: MIT
#include "automata/step/program_step.hpp"

#include <algorithm>
#include <cassert>
#include <map>

#include "automata/store/model.hpp"

namespace rmpl::automata {

ProgramStep::ProgramStep(const Program& program, const Plant& plant) : program_(program), theory_(model_theory(plant)) {
  initialise();
}

ProgramStep::ProgramStep(const Program& program) : program_(program), theory_(program.variables) { initialise(); }

void ProgramStep::initialise() {
  children_.resize(program_.locations.size());
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    const Location& location = program_.locations[l];
    if (location.parent) {
      assert(location.parent->index() < l && "a child comes after its parent");
      children_[location.parent->index()].emplace_back(l);
    }
    goals_.push_back(question(conjunction_of(location.goal)));
    maintenance_.push_back(compile(location.maintenance));
    auto& guards = guards_.emplace_back();
    for (const Arc& arc : location.arcs) guards.push_back(compile(arc.guard));
  }
  reset();
}

std::size_t ProgramStep::question(const Formula& formula) {
  questions_.push_back({theory_.encode(formula), std::nullopt});
  return questions_.size() - 1;
}

ProgramStep::Compiled ProgramStep::compile(const Condition& condition) {
  if (has_clock(condition.constraint)) return {&condition, std::nullopt, {}};
  return {&condition, question(condition.constraint), {}};
}

void ProgramStep::know(const Knowledge& knowledge) {
  if (known_ == knowledge.assignments) return;
  known_ = knowledge.assignments;
  for (Question& q : questions_) q.entailed.reset();
}

bool ProgramStep::entailed(std::size_t question) {
  auto& answer = questions_[question].entailed;
  if (!answer) answer = theory_.entails(known_, questions_[question].handle);
  return *answer;
}

void ProgramStep::reset() {
  started_.assign(program_.clocks.size(), std::nullopt);
  readings_ = started_;
  next_started_ = started_;
  marking_.clear();
  if (program_.locations.empty()) return;
  std::vector<bool> marked(program_.locations.size(), false);
  mark_fully(LocationId(0), marked);
  for (std::size_t l = 0; l < marked.size(); ++l) {
    if (marked[l]) marking_.emplace_back(l);
  }
}

void ProgramStep::resume(Marking marking, std::vector<std::optional<Ticks>> started) {
  assert(started.size() == program_.clocks.size() && "one entry a clock");
  marking_ = std::move(marking);
  started_ = std::move(started);
}

// m_F: the location and, recursively, the start locations of what it holds.
void ProgramStep::mark_fully(LocationId location, std::vector<bool>& marked) const {
  marked[location.index()] = true;
  for (const LocationId child : children_[location.index()]) {
    if (program_.locations[child.index()].start) mark_fully(child, marked);
  }
}

bool ProgramStep::holds(Compiled& compiled) {
  const Condition& condition = *compiled.condition;
  if (condition.is_trivial()) return true;
  if (compiled.question) return entailed(*compiled.question) == condition.entailed;
  Formula now = with_clocks(condition.constraint, [&](ClockId clock) -> const Ticks* {
    const auto& reading = readings_[clock.index()];
    return reading ? &*reading : nullptr;
  });
  auto known = std::find_if(compiled.variants.begin(), compiled.variants.end(),
                            [&](const auto& variant) { return variant.first == now; });
  if (known == compiled.variants.end()) {
    const std::size_t asked = question(now);
    known = compiled.variants.insert(known, {std::move(now), asked});
  }
  return entailed(known->second) == condition.entailed;
}

bool ProgramStep::achieved(LocationId location) {
  return program_.locations[location.index()].goal.empty() || entailed(goals_[location.index()]);
}

const Asserted& ProgramStep::begin(const Knowledge& knowledge, Ticks now) {
  know(knowledge);
  const auto& locations = program_.locations;
  // 1. Update active clocks.
  for (std::size_t c = 0; c < started_.size(); ++c) {
    readings_[c] = started_[c] ? std::optional<Ticks>(now - *started_[c]) : std::nullopt;
  }
  // 2. Check maintenance constraints: everything inside a violated composite is unmarked; the composite itself stays.
  // Violations are judged on m(i), before any unmarking. Parents come first, so one pass hands `unmarked` down.
  working_.assign(locations.size(), false);
  violated_.assign(locations.size(), false);
  for (const LocationId id : marking_) working_[id.index()] = true;
  for (const LocationId id : marking_) {
    violated_[id.index()] = !holds(maintenance_[id.index()]);
  }
  std::vector<bool> inside_violated(locations.size(), false);
  for (std::size_t l = 0; l < locations.size(); ++l) {
    if (!locations[l].parent) continue;
    const std::size_t parent = locations[l].parent->index();
    const bool parent_violated = violated_[parent] && locations[parent].composite;
    inside_violated[l] = inside_violated[parent] || parent_violated;
    if (inside_violated[l]) working_[l] = false;
  }
  // 3. Assert clock initialisations; a clock that runs already keeps its start (step 10 adds it back).
  next_started_ = started_;
  // 4. Set up the configuration goal.
  asserted_.goal.clear();
  asserted_.by.clear();
  asserted_.conflicts.clear();
  std::map<VariableId, std::pair<ValueId, LocationId>> goals;
  for (const LocationId id : marking_) {
    const Location& location = locations[id.index()];
    if (!working_[id.index()] || location.composite) continue;
    if (location.clock_start && !next_started_[location.clock_start->index()]) {
      next_started_[location.clock_start->index()] = now;
    }
    if (violated_[id.index()]) continue;
    for (const Assignment& goal : location.goal) {
      const auto [at, fresh] = goals.try_emplace(goal.variable, goal.value, id);
      if (!fresh && at->second.first != goal.value) {
        asserted_.conflicts.push_back({at->second.second, id, goal, {goal.variable, at->second.first}});
      }
    }
  }
  for (const auto& [variable, asserted] : goals) {
    asserted_.goal.push_back({variable, asserted.first});
    asserted_.by.push_back(asserted.second);
  }
  return asserted_;
}

void ProgramStep::finish(const Knowledge& knowledge) {
  know(knowledge);
  const auto& locations = program_.locations;
  std::vector<bool> next(locations.size(), false);
  std::vector<bool> leaves(locations.size(), false);  // has an enabled outgoing transition
  std::vector<LocationId> targets;
  const auto take = [&](std::size_t l) {
    for (std::size_t a = 0; a < locations[l].arcs.size(); ++a) {
      if (!holds(guards_[l][a])) continue;
      leaves[l] = true;
      targets.push_back(locations[l].arcs[a].target);
    }
  };
  // 7. Await incomplete goals; 8. enabled transitions of primitive locations.
  for (std::size_t l = 0; l < locations.size(); ++l) {
    if (!working_[l] || locations[l].composite) continue;
    const bool reached = achieved(LocationId(l));
    if (!reached && !violated_[l]) next[l] = true;
    if (reached || violated_[l]) take(l);
  }
  // 8. Composite locations, from the inside out: children come after their parents.
  std::vector<bool> busy(locations.size(), false);  // some subautomaton goes on or leaves
  for (std::size_t l = locations.size(); l-- > 0;) {
    if (locations[l].composite && working_[l] && !busy[l]) take(l);
    if (locations[l].parent && (busy[l] || next[l] || leaves[l])) busy[locations[l].parent->index()] = true;
  }
  // 9. Take transitions; re-mark the composites that hold a marked location.
  for (const LocationId target : targets) mark_fully(target, next);
  for (std::size_t l = locations.size(); l-- > 0;) {
    if (next[l] && locations[l].parent) next[locations[l].parent->index()] = true;
  }
  marking_.clear();
  for (std::size_t l = 0; l < next.size(); ++l) {
    if (next[l]) marking_.emplace_back(l);
  }
  // 10. Update the list of clock references.
  started_ = next_started_;
}

}  // namespace rmpl::automata
