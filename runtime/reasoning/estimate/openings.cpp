// Readings that components leave open, by elimination.
// SPDX-License-Identifier: MIT
#include "runtime/reasoning/estimate/openings.hpp"

#include <algorithm>
#include <set>

#include "automata/dependencies/constraints.hpp"
#include "automata/dependencies/plant_index.hpp"
#include "automata/store/elimination.hpp"

namespace rmpl::runtime {

using automata::Assignment;
using automata::ComponentId;
using automata::Constraint;
using automata::Elimination;
using automata::Formula;
using automata::ModeId;
using automata::ValueId;
using automata::VariableId;

/// The attributes of a plant taken away, and who reads what.
struct Openings::Analysis {
  const automata::Plant& plant;
  const automata::PlantIndex index{plant};
  const std::vector<Constraint> constraints = automata::constraints_of(plant);
  const Elimination elimination{plant.variables, constraints, all_attributes()};

  [[nodiscard]] std::vector<VariableId> all_attributes() const {
    std::vector<VariableId> result;
    for (std::size_t v = 0; v < plant.variables.size(); ++v) {
      if (!index.component_of(VariableId(v))) result.emplace_back(v);
    }
    return result;
  }

  [[nodiscard]] Told told(const Constraint& constraint, VariableId attribute) const {
    Told told;
    if (const auto& under = constraint.under)
      told.under = {*index.component_of(under->variable), ModeId(under->value.index())};
    const Formula& formula = constraint.formula;
    if (formula.kind != Formula::Kind::equality) return told;
    const VariableId other = formula.variable == attribute ? formula.other : formula.variable;
    if (other != attribute && !index.component_of(other)) told.equal = other;
    return told;
  }

  /// The components whose modes a constraint reads.
  void read_modes(const Constraint& constraint, std::set<ComponentId>& components) const {
    std::vector<VariableId> read = automata::variables_of(constraint.formula);
    if (constraint.under) read.push_back(constraint.under->variable);
    for (const VariableId v : read) {
      if (const auto component = index.component_of(v)) components.insert(*component);
    }
  }

  /// Of a component, by mode, by value of the attribute: whether the mode leaves it another value.
  using Leaves = std::vector<std::vector<bool>>;

  [[nodiscard]] static std::optional<Opening> opening(std::size_t value, const std::vector<ComponentId>& components,
                                                      const std::vector<Leaves>& leaves) {
    std::optional<Opening> best;
    std::ptrdiff_t most = 0;
    for (std::size_t c = 0; c < components.size(); ++c) {
      Opening own{components[c], {}};
      for (const std::vector<bool>& mode : leaves[c]) own.modes.push_back(mode[value]);
      const std::ptrdiff_t count = std::count(own.modes.begin(), own.modes.end(), true);
      if (count <= most) continue;
      most = count;
      best = std::move(own);
    }
    return best;
  }

  [[nodiscard]] Attribute attribute(VariableId variable) const {
    Attribute result;
    std::set<ComponentId> components;
    for (const std::size_t t : elimination.taken_by(variable)) {
      result.told.push_back(told(constraints[t], variable));
      read_modes(constraints[t], components);
    }
    result.components.assign(components.begin(), components.end());
    std::vector<Leaves> of_components;
    for (const ComponentId c : result.components) {
      of_components.push_back(elimination.leaves_another(variable, plant[c].mode));
    }
    for (std::size_t v = 0; v < plant.variables[variable].values.size(); ++v) {
      result.openings.push_back(opening(v, result.components, of_components));
    }
    return result;
  }
};

Openings::Openings(const automata::Plant& plant) {
  const Analysis analysis{plant};
  std::vector<VariableId> wanted = plant.observables;
  while (!wanted.empty()) {
    const VariableId variable = wanted.back();
    wanted.pop_back();
    if (!analysis.elimination.has_gone(variable) || attributes_.contains(variable)) continue;
    const Attribute& attribute = attributes_.emplace(variable, analysis.attribute(variable)).first->second;
    for (const Told& told : attribute.told) {
      if (told.equal) wanted.push_back(*told.equal);
    }
  }
}

const Openings::Attribute* Openings::find(VariableId variable) const {
  const auto known = attributes_.find(variable);
  return known == attributes_.end() ? nullptr : &known->second;
}

const Opening* Openings::of(Assignment reading) const {
  const Attribute* attribute = find(reading.variable);
  while (attribute != nullptr && attribute->told.size() == 1 && !attribute->told.front().under) {
    const auto& equal = attribute->told.front().equal;
    if (!equal) break;
    attribute = find(*equal);
  }
  if (attribute == nullptr) return nullptr;
  const auto& opening = attribute->openings[reading.value.index()];
  return opening ? &*opening : nullptr;
}

/// An attribute that went is chosen again after those that it is a copy of, so that it follows these. Who is needed for
/// it to be one, and for nothing else to be said of it, are all that what it took away reads.
bool Openings::opened_by(const automata::Modes& modes, Assignment reading, std::vector<ComponentId>& components) const {
  components.clear();
  const Attribute* attribute = find(reading.variable);
  while (attribute != nullptr) {
    const auto& opening = attribute->openings[reading.value.index()];
    const bool opened = opening && opening->modes[modes[opening->component.index()].index()];
    if (opened) {
      components.push_back(opening->component);
      break;
    }
    components.insert(components.end(), attribute->components.begin(), attribute->components.end());
    const auto in_force = [&](const Told& told) {
      return !told.under || modes[told.under->first.index()] == told.under->second;
    };
    const auto& told = attribute->told;
    const auto only = std::find_if(told.begin(), told.end(), in_force);
    if (only == told.end() || !only->equal || std::any_of(only + 1, told.end(), in_force)) return false;
    attribute = find(*only->equal);
  }
  if (attribute == nullptr) return false;
  std::sort(components.begin(), components.end());
  components.erase(std::unique(components.begin(), components.end()), components.end());
  return true;
}

OpeningFactors::OpeningFactors(const automata::Plant& plant, const Openings& openings,
                               const automata::Observation& observation) {
  for (const Assignment& reading : observation) {
    const Opening* const opening = openings_.emplace_back(openings.of(reading));
    if (opening == nullptr) continue;
    if (place_.empty()) place_.assign(plant.components.size(), none);
    std::uint32_t& place = place_[opening->component.index()];
    if (place == none) {
      place = static_cast<std::uint32_t>(factors_.size());
      factors_.emplace_back(opening->modes.size(), 1.0);
    }
    const auto values = static_cast<double>(plant.variables[reading.variable].values.size());
    for (std::size_t m = 0; m < opening->modes.size(); ++m) {
      if (opening->modes[m]) factors_[place][m] /= values;
    }
  }
}

}  // namespace rmpl::runtime
