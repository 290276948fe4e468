// The names of a log, looked up in a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "automata/dependencies/plant_index.hpp"
#include "automata/phca.hpp"
#include "automata/plant.hpp"
#include "automata/state.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::runtime {

/// Keeps a reference to the plant.
class LogNames {
 public:
  explicit LogNames(const automata::Plant& plant);

  /// The assignment that a name and a value are in their role. Throws base::InputError, with the nearest name, where
  /// the plant lacks it or it plays no such role.
  [[nodiscard]] automata::Assignment resolve(LogReader::Role role, const std::string& name,
                                             const std::string& value) const;

  /// The modes of all components. Throws base::InputError where one is not told.
  [[nodiscard]] automata::Modes all_modes(const std::vector<automata::Assignment>& told) const;

 private:
  [[nodiscard]] bool plays(LogReader::Role role, automata::VariableId variable) const;

  const automata::Plant& plant_;
  automata::PlantIndex index_;
};

/// The same over a model program.
automata::Assignment resolve(const automata::ModelProgram& program, LogReader::Role role, const std::string& name,
                             const std::string& value);

}  // namespace rmpl::runtime
