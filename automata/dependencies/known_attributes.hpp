// Attributes that the mode of one component tells.
//
// Where each mode of a component leaves an attribute one value, whoever reads the attribute reads the mode. A store
// whose modes are all assumed says the same if each constraint asks the mode in the attribute's place; and then the
// attribute links nobody. So does an attribute that one constraint equates to such a one, and so on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "automata/dependencies/constraints.hpp"
#include "automata/dependencies/plant_index.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// Keeps references to the plant and to its index.
class KnownAttributes {
 public:
  /// Of constraints of the plant, where these values are given.
  KnownAttributes(const Plant& plant, const PlantIndex& index, const std::vector<Constraint>& constraints,
                  std::span<const Assignment> given);

  /// With these in place of the constraints a store in which every mode is assumed, and what was given, is consistent
  /// where it was, and implies what it did.
  [[nodiscard]] const std::vector<Constraint>& constraints() const { return constraints_; }
  /// The same, which are not here any more then.
  [[nodiscard]] std::vector<Constraint> take_constraints() { return std::move(constraints_); }
  /// The formula with modes and values in place of what is known, folded where that makes it constant. `under`: where
  /// this is assumed.
  [[nodiscard]] Formula rewritten(const Formula& formula, std::optional<Assignment> under = std::nullopt) const;

 private:
  /// Which value an attribute has, by the mode of the component; one value where it is the same in all.
  struct Known {
    std::optional<ComponentId> component;
    std::vector<ValueId> values;
  };
  struct Told {
    Constraint constraint;
    std::vector<VariableId> variables;
    bool defines = false;  ///< it is what makes an attribute known, and stays as it is
    bool gone = false;
  };
  /// A value that a mode leaves to an attribute, and the constraint that does.
  struct Pin {
    ValueId value;
    std::size_t constraint;
  };
  using Pins = std::map<ModeId, Pin>;

  void look_at(std::size_t constraint);
  void rewrite(std::size_t constraint);
  /// The only value of the attribute with which the formula holds, where there is one; `given`: the mode read.
  [[nodiscard]] std::optional<ValueId> only_value(const Formula& formula, VariableId attribute,
                                                  std::optional<Assignment> given) const;
  void know(VariableId attribute, Known known);
  [[nodiscard]] Formula member_of(VariableId variable, const std::vector<ValueId>& values,
                                  std::optional<Assignment> under) const;
  [[nodiscard]] Formula equality_of(VariableId one, VariableId other, std::optional<Assignment> under) const;
  [[nodiscard]] bool is_open_attribute(VariableId variable) const;

  const Plant& plant_;
  const PlantIndex& index_;
  std::map<VariableId, Known> known_;
  std::vector<Told> told_;
  std::map<VariableId, std::vector<std::size_t>> readers_;
  std::map<std::pair<VariableId, ComponentId>, Pins> pins_;
  std::vector<std::size_t> open_;  ///< constraints to look at
  std::vector<VariableId> new_;    ///< known, while their readers do not tell yet
  std::vector<Constraint> constraints_;
};

}  // namespace rmpl::automata
