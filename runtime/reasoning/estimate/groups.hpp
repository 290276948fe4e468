// Independent groups: parts of a plant whose beliefs never influence each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/reasoning/estimate/plant_shapes.hpp"

namespace rmpl::runtime {

/// A part of a plant as a plant of its own, with its own numbering of variables; those that may be read come first, in
/// the order of the whole.
struct Group {
  std::size_t shape = 0;                          ///< of this plant (`Groups::plant`)
  std::vector<automata::ComponentId> components;  ///< in the whole plant, ascending; at least one
  std::vector<std::size_t> controls;              ///< positions in the whole plant's `controls`, ascending
  std::vector<automata::VariableId> variables;    ///< in the whole plant, ascending: those that readings may be of
  /// Whether a constraint of the store reads a control variable, so that a control action may contradict it.
  bool constrains_controls = false;
};

/// The finest partition of the components such that, given the control action, what one group does depends on itself
/// alone: two variables are linked where an interconnection or a mode's constraint reads both, and a component is
/// linked to all that its constraints and guards read. A control variable that only guards read links nothing, since
/// its value is given. One exception is left to the caller: a store that contradicts the control action enables
/// everything, everywhere (see `Group::constrains_controls`).
class Groups {
 public:
  explicit Groups(const automata::Plant& plant);

  [[nodiscard]] std::size_t size() const { return groups_.size(); }
  [[nodiscard]] const Group& operator[](std::size_t group) const { return groups_[group]; }
  [[nodiscard]] auto begin() const { return groups_.begin(); }
  [[nodiscard]] auto end() const { return groups_.end(); }
  /// The plants that the groups are, where these are several: one for all groups that are the same but for names.
  [[nodiscard]] const PlantShapes& shapes() const { return shapes_; }
  /// The plant that a group is, with the names of the first one of its shape.
  [[nodiscard]] const automata::Plant& plant(const Group& group) const { return shapes_[group.shape]; }

  /// The part of an observation that is a group's, for all of them. What is seen of a control variable that only guards
  /// read is nobody's: it is as likely in one state as in another.
  [[nodiscard]] std::vector<automata::Observation> divide(const automata::Observation& observation) const;

 private:
  struct Home {
    std::size_t group = 0;
    automata::VariableId variable;  ///< there
  };
  std::vector<Group> groups_;
  PlantShapes shapes_;
  std::vector<std::optional<Home>> homes_;  ///< per variable; none for a control variable that only guards read
};

}  // namespace rmpl::runtime
