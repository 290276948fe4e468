// Plants taken apart.
// SPDX-License-Identifier: MIT
#include "compiler/lint/plant/part.hpp"

#include <utility>

#include "automata/dependencies/dependencies.hpp"

namespace rmpl::compiler {

using automata::Formula;
using automata::Plant;
using automata::VariableId;

namespace {

class Division {
 public:
  explicit Division(const Plant& plant) : plant_(plant), part_of_(automata::Dependencies(plant).parts()) {}

  std::vector<PlantPart> run() {
    parts_.resize(part_of_.count);
    for (std::size_t v = 0; v < plant_.variables.size(); ++v) {
      PlantPart& part = part_with(VariableId(v));
      own_.push_back(part.plant.variables.add(plant_.variables[VariableId(v)]));
      part.variables.emplace_back(v);
    }
    for (std::size_t c = 0; c < plant_.components.size(); ++c) add_component(c);
    for (const automata::Interconnection& q : plant_.interconnections) add(q);
    for (const automata::Control& control : plant_.controls) {
      part_with(control.variable).plant.controls.push_back({own_[control.variable.index()], control.idle});
    }
    std::erase_if(parts_, [](const PlantPart& part) { return part.components.empty(); });
    return std::move(parts_);
  }

 private:
  PlantPart& part_with(VariableId variable) { return parts_[*part_of_[variable]]; }

  [[nodiscard]] Formula own(const Formula& formula) const {
    return renamed(
        formula, [this](VariableId v) { return own_[v.index()]; },
        [](VariableId, automata::ValueId value) { return value; });
  }

  void add_component(std::size_t c) {
    PlantPart& part = part_with(plant_.components[c].mode);
    part.components.emplace_back(c);
    automata::Component& copy = part.plant.components.emplace_back(plant_.components[c]);
    copy.mode = own_[copy.mode.index()];
    for (automata::Mode& mode : copy.modes) mode.constraint = own(mode.constraint);
    for (automata::Transition& transition : copy.transitions) transition.guard = own(transition.guard);
  }

  /// What reads nothing is no matter of any part.
  void add(const automata::Interconnection& q) {
    const std::vector<VariableId> variables = variables_of(q.constraint);
    if (variables.empty()) return;
    part_with(variables.front()).plant.interconnections.emplace_back(own(q.constraint), q.origin);
  }

  const Plant& plant_;
  automata::Classes part_of_;
  std::vector<PlantPart> parts_;
  std::vector<VariableId> own_;  ///< by variable of the whole, that of its part
};

}  // namespace

std::vector<PlantPart> parts_of(const Plant& plant) { return Division(plant).run(); }

}  // namespace rmpl::compiler
