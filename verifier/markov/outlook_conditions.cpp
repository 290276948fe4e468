// What a program asks of its plant, part by part.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <utility>

#include "base/partition.hpp"
#include "base/product.hpp"
#include "verifier/check/apart.hpp"
#include "verifier/markov/outlook.hpp"

namespace rmpl::verifier {

using automata::Formula;
using automata::LocationId;
using automata::Modes;

namespace {

/// Of modes of the parts that decide a formula, beyond which all is taken to be possible.
constexpr std::size_t most_combinations = 4096;

std::vector<std::size_t> both(std::vector<std::size_t> a, const std::vector<std::size_t>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

std::vector<Formula> disjuncts_of(const Formula& formula) {
  return formula.kind == Formula::Kind::disjunction ? formula.operands : std::vector<Formula>{formula};
}

}  // namespace

Outlook::Outlook(const automata::Program& program, const automata::Plant& plant, const Question& question, Meter& meter)
    : program_(program), slices_(plant), question_(question), meter_(meter), children_(program.locations.size()) {
  const auto& start = slices_.start({});
  known_ = start && automata::knowledge_asked_by(program).empty();
  if (!known_) return;
  base_ = *start;
  find_parts();
  known_ = std::none_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->is_too_large(); });
  if (!known_) return;
  compile();
  set_ends();
}

/// Parts of the plant that neither guards nor constraints connect, nor commands.
void Outlook::find_parts() {
  const std::vector<ConnectedPart> connected = connected_parts(slices_);
  base::Partition partition(connected.size());
  std::map<std::string, std::size_t> by_control;  // the first part that has it
  for (std::size_t p = 0; p < connected.size(); ++p) {
    const automata::Plant plant = slices_.part(connected[p].cone, connected[p].formulas).plant();
    for (const automata::Control& control : plant.controls) {
      partition.join(p, by_control.try_emplace(plant.variables[control.variable].name, p).first->second);
    }
  }
  std::vector<ConnectedPart> merged(connected.size());  // by root
  for (std::size_t p = 0; p < connected.size(); ++p) {
    ConnectedPart& whole = merged[partition.root(p)];
    whole.formulas.insert(whole.formulas.end(), connected[p].formulas.begin(), connected[p].formulas.end());
    whole.cone.insert(whole.cone.end(), connected[p].cone.begin(), connected[p].cone.end());
  }
  const std::vector<Formula> disjuncts = disjuncts_of(question_.target);
  for (ConnectedPart& part : merged) {
    if (part.cone.empty()) continue;
    std::sort(part.cone.begin(), part.cone.end());
    for (const Formula& disjunct : disjuncts) {
      if (meet(slices_.cone({&disjunct, 1}), part.cone)) part.formulas.push_back(disjunct);
    }
    parts_.push_back(std::make_unique<PartMoves>(part.cone, slices_.part(part.cone, part.formulas), question_.period));
  }
}

/// Where each disjunct of the target is up to one part.
void Outlook::set_ends() {
  std::map<std::size_t, std::vector<Formula>> by_part;
  for (const Formula& disjunct : disjuncts_of(question_.target)) {
    std::vector<std::size_t> parts;
    for (const std::size_t c : taken_apart(disjunct)) parts = both(std::move(parts), conjuncts_[c].parts);
    if (parts.size() != 1) return;
    by_part[parts.front()].push_back(disjunct);
  }
  for (auto& [part, disjuncts] : by_part) {
    parts_[part]->end_in(automata::disjunction(std::move(disjuncts)), question_.entailed);
    ends_.push_back(part);
  }
}

Outlook::Asked Outlook::taken_apart(const Formula& formula) {
  Asked result;
  for (const Formula& conjunct : automata::conjuncts_of(formula)) {
    result.push_back(conjuncts_.size());
    Conjunct& own = conjuncts_.emplace_back();
    own.cone = slices_.cone({&conjunct, 1});
    if (automata::is_of_states(conjunct)) own.handle = slices_.whole().theory().encode(conjunct);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (meet(parts_[p]->cone(), own.cone)) own.parts.push_back(p);
    }
  }
  return result;
}

Outlook::Condition Outlook::compiled(const automata::Condition& condition) {
  if (condition.is_trivial()) return {{}, true, true, &condition.constraint};
  return {taken_apart(condition.constraint), condition.entailed, false, &condition.constraint};
}

void Outlook::mark_fully(LocationId location, std::vector<LocationId>& marked) const {
  marked.push_back(location);
  for (const LocationId child : children_[location.index()]) {
    if (program_.locations[child.index()].start) mark_fully(child, marked);
  }
}

void Outlook::compile() {
  for (std::size_t l = 0; l < program_.locations.size(); ++l) {
    if (const auto& parent = program_.locations[l].parent) children_[parent->index()].emplace_back(l);
  }
  for (const automata::Location& location : program_.locations) {
    Location own;
    if (location.has_goal()) own.goal = taken_apart(automata::goal_of(location));
    for (const std::size_t c : own.goal) own.goal_parts = both(std::move(own.goal_parts), conjuncts_[c].parts);
    own.maintenance = compiled(location.maintenance);
    for (const automata::Arc& arc : location.arcs) {
      own.guards.push_back(compiled(arc.guard));
      std::vector<LocationId>& marked = own.targets.emplace_back();
      mark_fully(arc.target, marked);
      for (auto around = program_.locations[arc.target.index()].parent; around;
           around = program_.locations[around->index()].parent) {
        marked.push_back(*around);
      }
    }
    locations_.push_back(std::move(own));
  }
  // A target that is to be allowed is so where its negation is not implied.
  for (const Formula& conjunct : automata::conjuncts_of(question_.target)) {
    const Asked own = taken_apart(question_.entailed ? conjunct : automata::negation(conjunct));
    target_.insert(target_.end(), own.begin(), own.end());
  }
}

bool Outlook::holds_in(Conjunct& conjunct, const std::vector<PartMoves::Number>& numbers) {
  const auto known = conjunct.known.find(numbers);
  if (known != conjunct.known.end()) return known->second;
  Modes modes = base_;
  for (std::size_t i = 0; i < numbers.size(); ++i) parts_[conjunct.parts[i]]->assign(numbers[i], modes);
  const bool holds =
      slices_.whole().theory().entails(automata::assignments_of(slices_.plant(), modes), *conjunct.handle);
  conjunct.known.emplace(numbers, holds);
  return holds;
}

Outlook::Chances Outlook::chances(Conjunct& conjunct, const Future& future) {
  if (!conjunct.handle) return {true, true};
  std::vector<const PartMoves::Reach*> reaches;
  std::size_t combinations = 1;
  for (const std::size_t p : conjunct.parts) {
    reaches.push_back(future.open[p]);
    combinations = std::min(combinations * reaches.back()->size(), most_combinations + 1);
  }
  if (combinations > most_combinations) return {true, true};
  if (const auto known = conjunct.asked.find(reaches); known != conjunct.asked.end()) {
    return {known->second.first, known->second.second};
  }
  std::vector<PartMoves::Reach> lists;
  lists.reserve(reaches.size());
  for (const PartMoves::Reach* const reach : reaches) lists.push_back(*reach);
  Chances result{false, false};
  base::for_each_combination(lists, [&](const std::vector<PartMoves::Number>& numbers) {
    if (result.holds && result.fails) return;
    meter_.poll();
    (holds_in(conjunct, numbers) ? result.holds : result.fails) = true;
  });
  conjunct.asked.emplace(std::move(reaches), std::pair(result.holds, result.fails));
  return result;
}

/// A conjunction is implied where all of its conjuncts are.
Outlook::Chances Outlook::chances(const Asked& asked, const Future& future) {
  Chances result{true, false};
  for (const std::size_t c : asked) {
    const Chances own = chances(conjuncts_[c], future);
    result = {result.holds && own.holds, result.fails || own.fails};
  }
  return result;
}

Outlook::Chances Outlook::chances(const Condition& condition, const Future& future) {
  if (condition.trivial) return {true, false};
  const Chances implied = chances(condition.asked, future);
  return condition.entailed ? implied : Chances{implied.fails, implied.holds};
}

}  // namespace rmpl::verifier
