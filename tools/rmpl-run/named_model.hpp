// A plant and a program of the names in a trace alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "automata/plant.hpp"
#include "automata/program.hpp"

namespace rmpl::tools {

struct NamedModel {
  automata::Plant plant;
  automata::Program program;
};

/// What the lines of a trace name: components with modes, attributes with values, controls, locations with no words. It
/// can be looked at, and does nothing. `name` is the file's, for messages. Throws base::InputError where the text is no
/// trace.
NamedModel named_model(const std::string& trace, const std::string& name);

}  // namespace rmpl::tools
