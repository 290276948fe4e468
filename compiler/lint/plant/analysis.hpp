// What the findings about a plant share: its abstraction, and its instances by type.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "compiler/lint/plant/blame.hpp"
#include "compiler/lint/plant/questions.hpp"
#include "compiler/lint/plant/reach.hpp"

namespace rmpl::compiler {

/// A mode of a component.
struct PlantMode {
  automata::ComponentId component;
  automata::ModeId mode;
  auto operator<=>(const PlantMode&) const = default;
};
/// A transition of a component.
struct PlantTransition {
  automata::ComponentId component;
  automata::TransitionId transition;
  auto operator<=>(const PlantTransition&) const = default;
};

/// Keeps a reference to the plant. Made once for all findings.
class PlantAnalysis {
 public:
  explicit PlantAnalysis(const automata::Plant& plant);

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }
  [[nodiscard]] PlantQuestions& questions() { return questions_; }
  /// The dependencies of the plant's variables.
  [[nodiscard]] const automata::Locality& locality() const { return questions_.locality(); }
  [[nodiscard]] const automata::PlantIndex& index() const { return index_; }
  [[nodiscard]] bool observed(automata::VariableId variable) const { return observed_[variable.index()]; }
  /// The transitions from modes that are reached whose guards can hold and read the variable.
  [[nodiscard]] const std::vector<PlantTransition>& readers_of(automata::VariableId variable) const {
    return readers_[variable.index()];
  }
  /// The islands of the store that the component's mode has a part in, by position.
  [[nodiscard]] const std::vector<std::size_t>& islands_of(automata::ComponentId component) const {
    return islands_[component.index()];
  }
  /// Whether a transition sets out from a mode that is reached, has weight, and a guard that can hold.
  [[nodiscard]] bool can_happen(PlantTransition transition) const;
  /// Whether there is any possible state; else of `reach` only that is meant.
  [[nodiscard]] bool is_possible() const { return is_possible_; }
  [[nodiscard]] const Reach& reach() const { return reach_; }
  /// Instances of the type of a component, in order.
  [[nodiscard]] const std::vector<automata::ComponentId>& instances_of(const std::string& type) const {
    return instances_.at(type);
  }

  /// How many observations of an island are gone through for a pair of modes at most; one that was not done with them
  /// is tangled, and the next pairs get less. What is decided of a plant does not depend on the machine.
  std::size_t& patience(std::size_t island) { return patience_[island]; }

  /// Why something cannot be, with components kept to the modes that they reach.
  Blame& blame();
  /// The same with all modes.
  Blame& blame_at_large();

 private:
  void collect_readers();

  const automata::Plant& plant_;
  automata::PlantIndex index_;
  std::vector<bool> observed_;                         ///< by variable
  std::vector<std::vector<PlantTransition>> readers_;  ///< by variable
  std::vector<std::vector<std::size_t>> islands_;      ///< by component
  PlantQuestions questions_;
  bool is_possible_;
  Reach reach_;
  std::vector<std::size_t> patience_;  ///< by island
  std::map<std::string, std::vector<automata::ComponentId>> instances_;
  std::unique_ptr<Blame> blame_, blame_at_large_;
};

}  // namespace rmpl::compiler
