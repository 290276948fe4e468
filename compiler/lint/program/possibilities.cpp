// Questions to the solver about all states of a plant.
// SPDX-License-Identifier: MIT
#include "compiler/lint/program/possibilities.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "automata/store/model.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ClockId;
using automata::Formula;
using automata::Theory;
using automata::Ticks;
using automata::ValueId;
using automata::VariableId;

namespace {

void collect(const Formula& formula, std::map<ClockId, std::vector<Ticks>>& bounds) {
  if (formula.kind == Formula::Kind::clock) bounds[formula.clock].push_back(formula.bound);
  for (const Formula& operand : formula.operands) collect(operand, bounds);
}

/// One reading from each stretch that the bounds leave, and the bounds. A running clock reads more than 0 when it is
/// first read.
std::vector<Ticks> readings_between(std::vector<Ticks> bounds) {
  std::sort(bounds.begin(), bounds.end());
  bounds.erase(std::unique(bounds.begin(), bounds.end()), bounds.end());
  std::vector<Ticks> readings;
  Ticks below{0};
  for (const Ticks bound : bounds) {
    if (bound.count - below.count > 1) readings.push_back({below.count + (bound.count - below.count) / 2});
    if (bound > Ticks{0}) readings.push_back(bound);
    below = bound;
  }
  if (!below.is_infinite()) readings.push_back(below + Ticks{1});
  return readings;
}

}  // namespace

std::map<ClockId, std::vector<Ticks>> clock_bounds_of(const std::vector<const Formula*>& formulas) {
  std::map<ClockId, std::vector<Ticks>> bounds;
  for (const Formula* formula : formulas) collect(*formula, bounds);
  return bounds;
}

ClockCuts cuts_of(const std::vector<const Formula*>& formulas) {
  ClockCuts cuts;
  for (auto& [clock, of_clock] : clock_bounds_of(formulas)) cuts.emplace(clock, readings_between(std::move(of_clock)));
  return cuts;
}

automata::Variables open_table(const automata::Variables& variables, const automata::Plant* plant) {
  automata::Variables table = variables;
  if (plant != nullptr) return table;
  for (std::size_t v = 0; v < table.size(); ++v) table.add_value(VariableId(v), "another value");
  return table;
}

namespace {

/// Calls `visit` for each way to answer what is asked of the executive's knowledge, until it returns true: lint knows
/// no estimate, so that any answers may come together.
bool for_some_knowledge(const Formula& formula, const std::function<bool(const Formula&)>& visit) {
  std::vector<Formula> atoms;
  collect_knowledge(formula, atoms);
  if (atoms.empty()) return visit(formula);
  constexpr std::size_t most_atoms = 10;
  if (atoms.size() > most_atoms) return true;
  for (std::size_t way = 0; way < std::size_t{1} << atoms.size(); ++way) {
    const auto answer = [&](const Formula& atom) {
      const auto at = std::find(atoms.begin(), atoms.end(), atom);
      return ((way >> static_cast<std::size_t>(at - atoms.begin())) & 1) != 0;
    };
    if (visit(with_knowledge(formula, answer))) return true;
  }
  return false;
}

}  // namespace

bool for_some_reading(const Formula& formula, const std::function<bool(const Formula&)>& visit) {
  if (!has_clock(formula)) return for_some_knowledge(formula, visit);
  constexpr std::size_t limit = 4096;
  const ClockCuts cuts = cuts_of({&formula});
  std::size_t ways = 1;
  for (const auto& [clock, readings] : cuts) {
    ways *= readings.size() + 1;
    if (ways > limit) return true;
  }
  for (std::size_t way = 0; way < ways; ++way) {
    std::map<ClockId, Ticks> now;
    std::size_t rest = way;
    for (const auto& [clock, readings] : cuts) {
      const std::size_t choice = rest % (readings.size() + 1);
      rest /= readings.size() + 1;
      if (choice > 0) now.emplace(clock, readings[choice - 1]);
    }
    const auto reading = [&](ClockId clock) -> const Ticks* {
      const auto found = now.find(clock);
      return found == now.end() ? nullptr : &found->second;
    };
    if (for_some_knowledge(with_clocks(formula, reading), visit)) return true;
  }
  return false;
}

Possibilities::Possibilities(const automata::Variables& variables, const automata::Plant* plant)
    : plant_(plant), variables_(open_table(variables, plant)), theory_(variables_) {
  if (plant != nullptr) automata::tell_model(theory_, *plant);
}

bool Possibilities::consistent() { return theory_.consistent({}); }

bool Possibilities::can_hold(const Formula& formula) {
  return for_some_reading(formula, [&](const Formula& read) { return holds_somewhere(read); });
}

bool Possibilities::holds_somewhere(const Formula& formula) {
  constexpr std::size_t most_worlds = 256;
  for (const std::vector<ValueId>& world : worlds_) {
    if (evaluate(formula, [&](VariableId variable) { return world[variable.index()]; })) return true;
  }
  if (!theory_.allows({}, theory_.encode(formula))) return false;
  if (worlds_.size() < most_worlds) {
    auto& world = worlds_.emplace_back();
    for (std::size_t v = 0; v < variables_.size(); ++v) world.push_back(theory_.value(VariableId(v)));
  }
  return true;
}

std::vector<automata::Origin> Possibilities::blame(const Formula& formula) {
  if (plant_ == nullptr) return {};
  automata::Variables table = variables_;
  std::vector<std::pair<Assignment, automata::Origin>> told;
  std::vector<std::pair<Assignment, Formula>> constraints;
  const auto add = [&](Formula constraint, const automata::Origin& origin) {
    const VariableId switched = table.add({"constraint " + std::to_string(told.size()), {"off", "on"}});
    told.push_back({{switched, ValueId(1)}, origin});
    constraints.emplace_back(told.back().first, std::move(constraint));
  };
  for (const automata::Interconnection& q : plant_->interconnections) add(q.constraint, q.origin);
  for (const automata::Component& component : plant_->components) {
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      const automata::Mode& mode = component.modes[m];
      if (!mode.constraint.is_true()) add(implication(is(component.mode, ValueId(m)), mode.constraint), mode.origin);
    }
  }
  Theory theory(table);
  for (const auto& [assignment, constraint] : constraints) theory.tell_if(assignment, constraint);
  std::vector<Assignment> all;
  all.reserve(told.size());
  for (const auto& [assignment, origin] : told) all.push_back(assignment);
  std::vector<automata::Origin> origins;
  for_some_reading(formula, [&](const Formula& read) {
    const Theory::Handle handle = theory.encode(read);
    if (theory.allows(all, handle)) return true;
    for (const Assignment& one : theory.minimal_conflict(theory.conflict(), handle)) {
      const auto found = std::find_if(told.begin(), told.end(), [&](const auto& t) { return t.first == one; });
      if (std::find(origins.begin(), origins.end(), found->second) == origins.end()) origins.push_back(found->second);
    }
    return false;
  });
  return origins;
}

}  // namespace rmpl::compiler
