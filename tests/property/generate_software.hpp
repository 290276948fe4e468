// Random software in random plants.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "automata/logic/variables.hpp"
#include "automata/software/as_components.hpp"
#include "automata/software/model_component.hpp"

namespace rmpl::property {

/// Every way to give each of these a value.
std::vector<std::vector<automata::Assignment>> all_assignments(const automata::Variables& variables,
                                                               const std::vector<automata::VariableId>& of);

/// Adds a random program as a component; its variables may be those of the plant.
void add_software(automata::PlantWithModels& whole, const std::string& name);

/// Markings of a whole program, of which each thread's is the first of those that its mode stands for.
class LikeMarkings {
 public:
  /// `offsets`: of the locations of each model program in the whole.
  LikeMarkings(const automata::SoftwarePlant& plant, const std::vector<std::size_t>& offsets);

  /// What is no primitive location of a thread is left out.
  [[nodiscard]] std::set<automata::LocationId> first(const std::set<automata::LocationId>& marked) const;

 private:
  using Marked = std::set<automata::LocationId>;
  struct Thread {
    Marked all;                      ///< what it may mark
    std::map<Marked, Marked> first;  ///< by marking
  };
  std::vector<Thread> threads_;
};

}  // namespace rmpl::property
