// SPDX-License-Identifier: MIT
#include "automata/store/consistency.hpp"

#include <utility>

#include "automata/dependencies/known_attributes.hpp"
#include "automata/store/elimination.hpp"

namespace rmpl::automata {
namespace {

/// How many commands of one island are looked at each by itself.
constexpr std::size_t most_commands = 64;

}  // namespace

Consistency::Consistency(const Plant& plant, const PlantIndex& index, const Island& island,
                         Locality::Commanded commanded)
    : plant_(plant), index_(index), island_(island) {
  if (commanded == Locality::Commanded::no) {
    any_.emplace(folded({}));
    return;
  }
  std::size_t commands = 1;
  for (const std::size_t i : island.support.controls) {
    commands *= plant.variables[plant.controls[i].variable].values.size();
    if (commands > most_commands) break;
  }
  if (commands > most_commands) {
    any_.emplace(Answers{false, {plant, island.support}});
  } else {
    commanded_.resize(commands);
  }
}

Consistency::Answers& Consistency::of(const ControlAction& action) {
  if (any_) return *any_;
  std::size_t number = 0;
  for (const std::size_t i : island_.support.controls) {
    number = number * plant_.variables[plant_.controls[i].variable].values.size() + action[i].index();
  }
  if (!commanded_[number]) {
    std::vector<Assignment> command;
    for (const std::size_t i : island_.support.controls) command.push_back({plant_.controls[i].variable, action[i]});
    commanded_[number].emplace(folded(command));
  }
  return *commanded_[number];
}

Consistency::Answers Consistency::folded(const std::vector<Assignment>& command) const {
  const KnownAttributes known(plant_, index_, island_.constraints, command);
  const Elimination elimination(plant_.variables, known.constraints(), island_.attributes);
  Support support;
  for (const std::size_t left : elimination.left()) {
    const Constraint& constraint = known.constraints()[left];
    if (constraint.under) support.join({{*index_.component_of(constraint.under->variable)}, {}});
    for (const VariableId v : variables_of(constraint.formula)) {
      if (const auto component = index_.component_of(v)) support.join({{*component}, {}});
    }
  }
  return {elimination.left().empty(), {plant_, support}};
}

}  // namespace rmpl::automata
