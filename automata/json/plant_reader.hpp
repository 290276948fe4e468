// Reads plants from JSON, a type at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "automata/json/node.hpp"
#include "automata/plant.hpp"

namespace rmpl::automata {

/// Reads one plant. Throws JsonError where anything is wrong.
class PlantReader {
 public:
  /// One of its "types". Those that were read need not be there any more when the plant is.
  void read_type(const Node& node);
  Plant read_plant(const Node& node);

 private:
  /// A plant or a type, with names relative to itself.
  struct Part {
    Plant plant;
    std::size_t weight = 0;  ///< with all instances
    std::size_t depth = 0;   ///< of instances within instances
  };

  Part read(const Node& node);
  void grow(Part& part, std::size_t more, const Node& blame);
  void add_variable(Part& part, const Node& node);
  void add_component(Part& part, const Node& node);
  void add_instance(Part& part, const Node& node);
  void add_interconnection(Part& part, const Node& node);
  void add_control(Part& part, const Node& node);
  [[nodiscard]] VariableId attribute(const Plant& plant, const Node& node) const;

  std::unordered_map<std::string, Part> types_;
  std::unordered_set<VariableId> modes_;   ///< of what is being read
  std::unordered_set<std::string> taken_;  ///< what names in it begin with, up to a dot
  std::size_t made_ = 0;
};

}  // namespace rmpl::automata
