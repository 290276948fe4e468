// Questions about a plant whose components are kept to some of their modes.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/questions.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "automata/store/model.hpp"
#include "compiler/lint/plant/exclusions.hpp"

namespace rmpl::compiler {

using automata::Assignment;
using automata::ComponentId;
using automata::Formula;
using automata::ModeId;
using automata::ValueId;
using automata::VariableId;

namespace {

constexpr ValueId yes(1);

/// How many guards may be asked about again, with what was tried in vain excluded, and how often each: of a plant whose
/// faults leave most guards open. Others stay open whether others imply them.
constexpr std::size_t most_searches = 128;
constexpr std::size_t patience = 256;
constexpr std::size_t whole_patience = 4096;  ///< of all guards together

/// The plant's variables, for each mode one that excludes it where it is assumed, and for each search one under which
/// it tells what it excludes.
automata::Variables with_exclusions(const automata::Plant& plant) {
  automata::Variables result = plant.variables;
  add_exclusions(result, plant);
  for (std::size_t s = 0; s < most_searches; ++s) result.add({"search " + std::to_string(s), {"no", "yes"}});
  return result;
}

std::vector<std::size_t> first_exclusions(const automata::Plant& plant) {
  std::vector<std::size_t> result;
  std::size_t next = plant.variables.size();
  for (const automata::Component& component : plant.components) {
    result.push_back(next);
    next += component.modes.size();
  }
  result.push_back(next);
  return result;
}

}  // namespace

ModeSets all_modes(const automata::Plant& plant) {
  ModeSets result;
  for (const automata::Component& component : plant.components) result.emplace_back(component.modes.size(), true);
  return result;
}

PlantQuestions::PlantQuestions(const automata::Plant& plant)
    : plant_(plant),
      locality_(plant),
      index_(plant),
      first_exclusion_(first_exclusions(plant)),
      theory_(with_exclusions(plant), automata::Theory::Upkeep::maintained),
      excluded_(plant.components.size()),
      parts_(automata::Dependencies(plant).parts()),
      components_(parts_.count) {
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    if (const auto part = parts_[plant.components[c].mode]) components_[*part].push_back(c);
  }
  automata::tell_model(theory_, plant);
  for (std::size_t c = 0; c < plant.components.size(); ++c) {
    const automata::Component& component = plant.components[c];
    for (std::size_t m = 0; m < component.modes.size(); ++m) {
      theory_.tell_if(exclusion(ComponentId(c), m), negation(is(component.mode, ValueId(m))));
    }
  }
}

Assignment PlantQuestions::exclusion(ComponentId component, std::size_t mode) const {
  return {VariableId(first_exclusion_[component.index()] + mode), yes};
}

void PlantQuestions::keep_to(const ModeSets& modes) {
  all_can_be_.reset();
  for (std::size_t c = 0; c < modes.size(); ++c) {
    excluded_[c].clear();
    for (std::size_t m = 0; m < modes[c].size(); ++m) {
      if (!modes[c][m]) excluded_[c].push_back(exclusion(ComponentId(c), m));
    }
  }
}

void PlantQuestions::allow(ComponentId component, ModeId mode) {
  std::erase(excluded_[component.index()], exclusion(component, mode.index()));
  if (all_can_be_ && !*all_can_be_) all_can_be_.reset();
}

bool PlantQuestions::all_can_be() {
  if (!all_can_be_) {
    std::vector<Assignment> all;
    for (const auto& excluded : excluded_) all.insert(all.end(), excluded.begin(), excluded.end());
    all_can_be_ = theory_.consistent(all);
  }
  return *all_can_be_;
}

std::vector<Assignment> PlantQuestions::assumed(std::span<const Assignment> assumptions,
                                                std::span<const VariableId> variables) {
  std::vector<Assignment> result(assumptions.begin(), assumptions.end());
  std::vector<std::size_t> free;
  std::vector<std::size_t> parts;
  for (const Assignment& a : assumptions) {
    if (const auto component = index_.component_of(a.variable)) free.push_back(component->index());
    if (const auto part = parts_[a.variable]) parts.push_back(*part);
  }
  for (const VariableId v : variables) {
    if (const auto part = parts_[v]) parts.push_back(*part);
  }
  if (parts.empty() || !all_can_be()) {
    parts.resize(parts_.count);
    std::iota(parts.begin(), parts.end(), std::size_t{0});
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  for (const std::size_t part : parts) {
    for (const std::size_t c : components_[part]) {
      if (excluded_[c].empty() || std::find(free.begin(), free.end(), c) != free.end()) continue;
      result.insert(result.end(), excluded_[c].begin(), excluded_[c].end());
    }
  }
  return result;
}

bool PlantQuestions::possible(std::span<const Assignment> assumptions) {
  return theory_.consistent(assumed(assumptions, {}));
}

bool PlantQuestions::possible(std::span<const Assignment> assumptions, const Formula& formula) {
  return theory_.allows(assumed(assumptions, variables_of(formula)), theory_.encode(formula));
}

std::vector<Assignment> PlantQuestions::due_to() const {
  std::vector<Assignment> result;
  for (const Assignment& a : theory_.conflict()) {
    if (a.variable.index() < plant_.variables.size() || a.variable.index() >= first_exclusion_.back()) continue;
    const auto after = std::upper_bound(first_exclusion_.begin(), first_exclusion_.end(), a.variable.index());
    const auto component = static_cast<std::size_t>(after - first_exclusion_.begin()) - 1;
    result.push_back({plant_.components[component].mode, ValueId(a.variable.index() - first_exclusion_[component])});
  }
  return result;
}

bool PlantQuestions::follows(std::span<const Assignment> context, const Formula& formula) {
  return theory_.entails(context, theory_.encode(formula));
}

/// The modes and controls of the support in the model that was found.
std::vector<Assignment> PlantQuestions::context(const automata::Support& support) const {
  std::vector<Assignment> result;
  for (const ComponentId c : support.components) {
    result.push_back({plant_[c].mode, theory_.value(plant_[c].mode)});
  }
  for (const std::size_t control : support.controls) {
    const VariableId variable = plant_.controls[control].variable;
    result.push_back({variable, theory_.value(variable)});
  }
  return result;
}

std::vector<Assignment> PlantQuestions::values(std::span<const VariableId> variables) const {
  std::vector<Assignment> result;
  for (const VariableId v : variables) result.push_back({v, theory_.value(v)});
  return result;
}

/// The same with all that is read in nominal modes, which decide most: fault modes leave much open.
bool PlantQuestions::try_nominal(ComponentId component, ModeId mode, const Formula& together,
                                 const automata::Support& support) {
  const Assignment own{plant_[component].mode, ValueId(mode.index())};
  std::vector<Assignment> assumptions = assumed({&own, 1}, variables_of(together));
  for (const ComponentId c : support.components) {
    if (c == component) continue;
    for (std::size_t m = 0; m < plant_[c].modes.size(); ++m) {
      if (plant_[c].modes[m].fault) assumptions.push_back(exclusion(c, m));
    }
  }
  return theory_.allows(assumptions, theory_.encode(together));
}

Implied PlantQuestions::implied(ComponentId component, ModeId mode, std::span<const Formula* const> guards) {
  const Assignment own{plant_[component].mode, ValueId(mode.index())};
  std::vector<Formula> parts;
  automata::Support support{{component}, {}};
  for (const Formula* guard : guards) {
    parts.push_back(*guard);
    support.join(locality_.support_of(*guard));
  }
  const std::vector<VariableId> variables = variables_of(conjunction(parts));
  Implied result;
  const auto is_implied = [&] {
    result.context = context(support);
    result.read = values(variables);
    return std::all_of(guards.begin(), guards.end(),
                       [&](const Formula* guard) { return follows(result.context, *guard); });
  };
  if (try_nominal(component, mode, conjunction(parts), support) && is_implied()) {
    result.verdict = Implied::Verdict::yes;
    return result;
  }
  if (!possible({&own, 1}, conjunction(parts))) {
    result.verdict = Implied::Verdict::no;
    result.due_to = due_to();
    return result;
  }
  if (is_implied()) {
    result.verdict = Implied::Verdict::yes;
    return result;
  }
  if (searches_ == most_searches || tried_ >= whole_patience) return result;
  // What is excluded is told under a variable of the search: a clause each, which is satisfied for good afterwards.
  const Assignment search{VariableId(first_exclusion_.back() + searches_++), yes};
  std::vector<Assignment> assumptions = assumed({&own, 1}, variables);
  assumptions.push_back(search);
  for (std::size_t tried = 1; tried < patience && tried_ < whole_patience; ++tried, ++tried_) {
    std::vector<Formula> others;
    for (const Assignment& a : result.context) others.push_back(negation(is(a.variable, a.value)));
    theory_.tell_if(search, automata::disjunction(std::move(others)));
    if (!theory_.allows(assumptions, theory_.encode(conjunction(parts)))) {
      result.verdict = Implied::Verdict::no;
      result.due_to = due_to();
      break;
    }
    if (is_implied()) {
      result.verdict = Implied::Verdict::yes;
      break;
    }
  }
  theory_.tell(negation(is(search.variable, search.value)));
  return result;
}

}  // namespace rmpl::compiler
