// Two copies of islands, compared by all that can be seen of them.
//
// That the same observations are possible in both is no question to SAT alone ("for each observation of one there are
// hidden values of the other"). But where modes and commands determine what is seen, as they mostly do, two copies that
// differ show a difference, and no such copies prove that there is none. Where they leave it open, observations are
// gone through one by one.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/copies.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rmpl::compiler {

using automata::Assignment;
using automata::ComponentId;
using automata::Constraint;
using automata::Island;
using automata::ModeId;
using automata::ValueId;
using automata::Variables;

PlantCopies::PlantCopies(PlantAnalysis& analysis, ComponentId component, std::vector<std::size_t> islands,
                         std::vector<const Formula*> guards)
    : analysis_(analysis),
      plant_(analysis.plant()),
      component_(component),
      islands_(std::move(islands)),
      guards_(std::move(guards)) {
  collect();
  theory_.emplace(declare(), automata::Theory::Upkeep::maintained);
  tell();
}

void PlantCopies::collect() {
  std::set<ComponentId> read;
  for (const std::size_t i : islands_) {
    const Island& island = analysis_.locality().islands()[i];
    read.insert(island.support.components.begin(), island.support.components.end());
    for (const VariableId v : island.attributes) (analysis_.index().control_of(v) ? controls_ : copied_).push_back(v);
  }
  read.erase(component_);
  others_.assign(read.begin(), read.end());
  for (const std::size_t i : analysis_.islands_of(component_)) beside_.join(analysis_.locality().islands()[i].support);
  std::erase(beside_.components, component_);
  for (const VariableId v : copied_) {
    if (analysis_.observed(v)) observed_.push_back(v);
  }
}

/// What guards read besides has some value or other, the same in both copies.
Variables PlantCopies::declare() {
  Variables result;
  const auto copy = [&](VariableId v, bool twice) {
    const automata::Variable& variable = plant_.variables[v];
    const VariableId first = result.add(variable);
    copies_[v] = {first, twice ? result.add({variable.name + " in the other", variable.values}) : first};
  };
  copy(plant_[component_].mode, true);
  for (const ComponentId c : others_) copy(plant_[c].mode, false);
  for (const VariableId v : controls_) copy(v, false);
  for (const VariableId v : copied_) copy(v, true);
  for (const Formula* guard : guards_) {
    for (const VariableId v : variables_of(*guard)) {
      if (!copies_.contains(v)) copy(v, false);
    }
  }
  return result;
}

automata::VariableId PlantCopies::map(VariableId variable, bool second) const {
  const Copies& copies = copies_.at(variable);
  return second ? copies.second : copies.first;
}

automata::Formula PlantCopies::copied(const Formula& formula, bool second) const {
  return renamed(
      formula, [&](VariableId v) { return map(v, second); }, [](VariableId, ValueId value) { return value; });
}

void PlantCopies::tell() {
  for (const std::size_t i : islands_) {
    for (const Constraint& constraint : analysis_.locality().islands()[i].constraints) {
      const std::vector<VariableId> variables = variables_of(constraint.formula);
      const VariableId own = plant_[component_].mode;
      if (std::find(variables.begin(), variables.end(), own) != variables.end()) read_by_interconnections_ = true;
      for (const bool second : {false, true}) {
        const Formula formula = copied(constraint.formula, second);
        if (constraint.under) {
          theory_->tell_if({map(constraint.under->variable, second), constraint.under->value}, formula);
        } else {
          theory_->tell(formula);
        }
      }
    }
  }
  for (const ComponentId c : others_) {
    const std::vector<bool>& reached = analysis_.reach().reached[c.index()];
    for (std::size_t m = 0; m < reached.size(); ++m) {
      if (!reached[m]) theory_->tell(negation(is(map(plant_[c].mode, false), ValueId(m))));
    }
  }
}

automata::Formula PlantCopies::differ() const {
  std::vector<Formula> parts;
  for (const VariableId v : observed_) parts.push_back(negation(equality(map(v, false), map(v, true))));
  return disjunction(std::move(parts));
}

std::vector<Assignment> PlantCopies::in(ModeId a, ModeId b) const {
  const VariableId mode = plant_[component_].mode;
  return {{map(mode, false), ValueId(a.index())}, {map(mode, true), ValueId(b.index())}};
}

bool PlantCopies::allows(std::span<const Assignment> assumptions, const Formula& formula) {
  return theory_->allows(assumptions, theory_->encode(formula));
}

/// What the islands have of the constraint of a mode.
automata::Formula PlantCopies::constraint(ModeId mode) const {
  std::vector<Formula> parts;
  const Assignment own{plant_[component_].mode, ValueId(mode.index())};
  for (const std::size_t i : islands_) {
    for (const Constraint& one : analysis_.locality().islands()[i].constraints) {
      if (one.under == own) parts.push_back(copied(one.formula, false));
    }
  }
  return conjunction(std::move(parts));
}

/// Whether the constraints of the modes are the same, whatever else is so, and nothing else asks for the mode.
bool PlantCopies::equal_constraints(ModeId a, ModeId b) {
  const auto implies = [&](ModeId mode, ModeId other) {
    const Assignment own{map(plant_[component_].mode, false), ValueId(mode.index())};
    return !allows({&own, 1}, negation(constraint(other)));
  };
  return !read_by_interconnections_ && implies(a, b) && implies(b, a);
}

const PlantCopies::Told& PlantCopies::told_by(ModeId mode) {
  told_.resize(plant_[component_].modes.size());
  std::optional<Told>& known = told_[mode.index()];
  if (known) return *known;
  known.emplace(observed_.size());
  const Assignment own{plant_[component_].mode, ValueId(mode.index())};
  if (!analysis_.questions().possible(std::span(&own, 1))) return *known;
  const Assignment copied{map(own.variable, false), own.value};
  if (!theory_->consistent({&copied, 1})) return *known;
  Told values(observed_.size());
  for (std::size_t v = 0; v < observed_.size(); ++v) values[v] = theory_->value(map(observed_[v], false));
  for (std::size_t v = 0; v < observed_.size(); ++v) {
    const bool open = theory_->allows_other({&copied, 1}, {map(observed_[v], false), *values[v]});
    if (!open) (*known)[v] = values[v];
  }
  return *known;
}

bool PlantCopies::told_apart(ModeId a, ModeId b) {
  if (!others_.empty() || !controls_.empty() || !beside_.components.empty() || !beside_.controls.empty()) return false;
  const Told& first = told_by(a);
  const Told& second = told_by(b);
  for (std::size_t v = 0; v < observed_.size(); ++v) {
    if (first[v] && second[v] && *first[v] != *second[v]) return true;
  }
  return false;
}

std::optional<bool> PlantCopies::look_alike(ModeId a, ModeId b) {
  // Of many modes most pairs are seen to differ without a question.
  if (told_apart(a, b)) return false;
  if (observed_.empty() || equal_constraints(a, b) || !allows(in(a, b), differ())) return true;
  if (value_tells(a, b) || value_tells(b, a)) return false;
  const std::optional<bool> one_way = explains_all(a, b);
  return one_way == true ? explains_all(b, a) : one_way;
}

/// Whether each observation that is possible in the first mode is possible in the second.
std::optional<bool> PlantCopies::explains_all(ModeId a, ModeId b) {
  constexpr std::size_t tangled = 2;
  std::size_t& patience = analysis_.patience(islands_.front());
  std::vector<Formula> parts{differ()};
  for (std::size_t tried = 0; tried < patience; ++tried) {
    if (!allows(in(a, b), conjunction(parts))) return true;
    const std::vector<Assignment> shared = context();
    std::vector<Assignment> seen, explained = in(a, b);
    explained.insert(explained.end(), shared.begin(), shared.end());
    for (const VariableId v : observed_) {
      const ValueId value = theory_->value(map(v, false));
      seen.push_back({map(v, false), value});
      explained.push_back({map(v, true), value});
    }
    const std::optional<bool> state = is_state(a, b, shared);
    if (!state) return std::nullopt;
    if (!*state) {
      parts.push_back(negation(conjunction_of(shared)));
      continue;
    }
    if (!theory_->consistent(explained)) return false;
    seen.insert(seen.end(), shared.begin(), shared.end());
    parts.push_back(negation(conjunction_of(seen)));
  }
  patience = std::min(patience, tangled);
  return std::nullopt;
}

/// In the model that was found, what the copies share: modes and controls, as variables of the theory.
std::vector<Assignment> PlantCopies::context() const {
  std::vector<Assignment> result;
  const auto add = [&](VariableId v) { result.push_back({map(v, false), theory_->value(map(v, false))}); };
  for (const ComponentId c : others_) add(plant_[c].mode);
  for (const VariableId v : controls_) add(v);
  return result;
}

/// Whether the whole plant has states with either mode that agree in the context and in all other modes. Nothing
/// where that was not found out.
std::optional<bool> PlantCopies::is_state(ModeId a, ModeId b, std::vector<Assignment> context) {
  std::size_t next = 0;
  for (const ComponentId c : others_) context[next++].variable = plant_[c].mode;
  for (const VariableId v : controls_) context[next++].variable = v;
  const auto with = [&](ModeId mode, std::vector<Assignment> others) {
    others.push_back({plant_[component_].mode, ValueId(mode.index())});
    return others;
  };
  std::vector<Formula> parts;
  for (std::size_t tried = 0; tried < 16; ++tried) {
    if (!analysis_.questions().possible(with(a, context), conjunction(parts))) return false;
    // The islands that this leaves out are as they are in either mode.
    const std::vector<Assignment> beside = analysis_.questions().context(beside_);
    if (analysis_.questions().possible(with(b, beside))) return true;
    parts.push_back(negation(conjunction_of(beside)));
  }
  return std::nullopt;
}

std::optional<bool> PlantCopies::go_with_the_same(ModeId a, ModeId b) {
  constexpr std::size_t patience = 64;
  std::vector<Formula> parts;
  for (std::size_t tried = 0; tried < patience; ++tried) {
    if (!allows(in(a, b), conjunction(parts))) return false;
    const std::vector<Assignment> shared = context();
    const std::optional<bool> state = is_state(a, b, shared);
    if (state != false) return state;
    parts.push_back(negation(conjunction_of(shared)));
  }
  return std::nullopt;
}

/// Whether some reading is possible in the first mode, and never in the second: most sensors tell by that.
bool PlantCopies::value_tells(ModeId a, ModeId b) {
  const VariableId mode = plant_[component_].mode;
  const Assignment first{map(mode, false), ValueId(a.index())}, second{map(mode, false), ValueId(b.index())};
  for (const VariableId v : observed_) {
    for (std::size_t x = 0; x < plant_.variables[v].values.size(); ++x) {
      const Formula reads = is(map(v, false), ValueId(x));
      if (!allows({&first, 1}, reads) || allows({&second, 1}, reads)) continue;
      if (allows(in(a, b), reads) && is_state(a, b, context()) == true) return true;
    }
  }
  return false;
}

bool PlantCopies::mean_alike(ModeId a, ModeId b) {
  if (guards_.empty()) return true;
  const bool read = std::any_of(guards_.begin(), guards_.end(), [&](const Formula* guard) {
    const std::vector<VariableId> variables = variables_of(*guard);
    return std::binary_search(variables.begin(), variables.end(), plant_[component_].mode);
  });
  if (!read && equal_constraints(a, b)) return true;
  std::vector<Formula> parts;
  for (const Formula* guard : guards_) {
    parts.push_back(negation(equivalence(copied(*guard, false), copied(*guard, true))));
  }
  return !allows(in(a, b), disjunction(std::move(parts)));
}

std::vector<automata::VariableId> PlantCopies::would_tell(ModeId a, ModeId b, std::span<const VariableId> attributes) {
  std::vector<VariableId> result;
  for (const VariableId v : attributes) {
    if (analysis_.observed(v) || analysis_.index().control_of(v) || !copies_.contains(v)) continue;
    if (!allows(in(a, b), equality(map(v, false), map(v, true)))) result.push_back(v);
  }
  return result;
}

}  // namespace rmpl::compiler
