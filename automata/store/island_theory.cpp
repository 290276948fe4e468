// SPDX-License-Identifier: MIT
#include "automata/store/island_theory.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace rmpl::automata {

std::size_t IslandTheory::watch(const Formula& formula) {
  CHECK(!theory_);
  const auto known = std::find(formulas_.begin(), formulas_.end(), formula);
  if (known != formulas_.end()) return static_cast<std::size_t>(known - formulas_.begin());
  formulas_.push_back(formula);
  return formulas_.size() - 1;
}

std::optional<VariableId> IslandTheory::own(VariableId variable) const {
  const auto& components = island_->support.components;
  const auto& attributes = island_->attributes;
  const auto& controls = island_->support.controls;
  const auto at = std::lower_bound(attributes.begin(), attributes.end(), variable);
  if (at != attributes.end() && *at == variable) {
    return VariableId(components.size() + static_cast<std::size_t>(at - attributes.begin()));
  }
  const auto component =
      std::find_if(components.begin(), components.end(), [&](ComponentId c) { return (*plant_)[c].mode == variable; });
  if (component != components.end()) return VariableId(static_cast<std::size_t>(component - components.begin()));
  const auto control = std::find_if(controls.begin(), controls.end(),
                                    [&](std::size_t i) { return plant_->controls[i].variable == variable; });
  if (control == controls.end()) return std::nullopt;
  return VariableId(components.size() + attributes.size() + static_cast<std::size_t>(control - controls.begin()));
}

VariableId IslandTheory::of_plant(VariableId own) const {
  const auto& components = island_->support.components;
  const auto& attributes = island_->attributes;
  if (own.index() < components.size()) return (*plant_)[components[own.index()]].mode;
  const std::size_t beyond = own.index() - components.size();
  if (beyond < attributes.size()) return attributes[beyond];
  return plant_->controls[island_->support.controls[beyond - attributes.size()]].variable;
}

VariableId IslandTheory::control(std::size_t position) const {
  const auto variable = own(plant_->controls[position].variable);
  CHECK(variable && "a support has the controls that it reads");
  return *variable;
}

Theory& IslandTheory::operator()() {
  if (theory_) return *theory_;
  Variables variables;
  for (const ComponentId c : island_->support.components) variables.add(plant_->variables[(*plant_)[c].mode]);
  for (const VariableId v : island_->attributes) variables.add(plant_->variables[v]);
  for (const std::size_t i : island_->support.controls) {
    const VariableId v = plant_->controls[i].variable;
    if (!variables.find(plant_->variables.name(v))) variables.add(plant_->variables[v]);
  }
  const auto translated = [this](const Formula& formula) {
    const auto to_own = [this](VariableId v) {
      const auto result = own(v);
      CHECK(result && "an island knows what its constraints read");
      return *result;
    };
    return renamed(formula, to_own, [](VariableId, ValueId value) { return value; });
  };
  theory_.emplace(variables, Theory::Upkeep::maintained);
  for (const Constraint& constraint : island_->constraints) {
    if (constraint.under) {
      theory_->tell_if({own(constraint.under->variable).value(), constraint.under->value},
                       translated(constraint.formula));
    } else {
      theory_->tell(translated(constraint.formula));
    }
  }
  for (const Formula& formula : formulas_) handles_.push_back(theory_->encode(translated(formula)));
  return *theory_;
}

std::vector<Assignment> IslandTheory::assumptions(const Modes& modes) const {
  std::vector<Assignment> result;
  const auto& components = island_->support.components;
  result.reserve(components.size() + island_->support.controls.size());
  for (std::size_t i = 0; i < components.size(); ++i) {
    result.push_back({VariableId(i), ValueId(modes[components[i].index()].index())});
  }
  return result;
}

std::vector<Assignment> IslandTheory::assumptions(const Modes& modes, const ControlAction& action) const {
  std::vector<Assignment> result = assumptions(modes);
  for (const std::size_t i : island_->support.controls) result.push_back({control(i), action[i]});
  return result;
}

}  // namespace rmpl::automata
