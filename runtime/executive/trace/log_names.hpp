// The names of a log, looked up in a plant.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "runtime/executive/trace/log.hpp"

namespace rmpl::runtime {

/// The assignment that a name and a value are in their role. Throws base::InputError, with the nearest name, where the
/// plant lacks it or it plays no such role.
automata::Assignment resolve(const automata::Plant& plant, LogReader::Role role, const std::string& name,
                             const std::string& value);

/// The same over a model program.
automata::Assignment resolve(const automata::ModelProgram& program, LogReader::Role role, const std::string& name,
                             const std::string& value);

}  // namespace rmpl::runtime
