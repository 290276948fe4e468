// A part of a plant as a plant of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::verifier {

/// Some components of a plant, with those attributes, controls and constraints that have to do with them, in the order
/// in which the plant has them; and the way in and out.
class Part {
 public:
  /// What of the plant is in the part; components and interconnections ascending, by variable whether it is kept. Of an
  /// interconnection only the conjuncts are kept that read what is kept.
  struct Kept {
    std::vector<automata::ComponentId> components;
    std::vector<bool> variables;
    std::vector<std::size_t> interconnections;
  };
  Part(const automata::Plant& whole, const Kept& kept);

  [[nodiscard]] const automata::Plant& plant() const { return plant_; }

  /// A formula over variables of the part, in its own terms.
  [[nodiscard]] automata::Formula into(const automata::Formula& formula) const;
  /// Those assignments whose variables are in the part.
  [[nodiscard]] std::vector<automata::Assignment> into(const std::vector<automata::Assignment>& assignments) const;
  /// The component of the whole.
  [[nodiscard]] automata::ComponentId out(automata::ComponentId component) const {
    return components_[component.index()];
  }
  /// The modes of the whole where the part has these, and the others those of `rest`.
  [[nodiscard]] automata::Modes out(const automata::Modes& modes, const automata::Modes& rest) const;
  /// The control action of the whole, idle outside the part.
  [[nodiscard]] automata::ControlAction out(const automata::ControlAction& action) const;

 private:
  std::vector<std::optional<automata::VariableId>> own_;  ///< by variable of the whole
  std::vector<automata::ComponentId> components_;         ///< by component of the part
  std::vector<std::size_t> controls_;                     ///< by control of the part, the position in the whole
  automata::ControlAction idle_;                          ///< of the whole
  automata::Plant plant_;
};

}  // namespace rmpl::verifier
