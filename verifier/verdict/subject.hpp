// What a verdict is about.
// SPDX-License-Identifier: MIT
#pragma once

#include "automata/plant.hpp"
#include "automata/program.hpp"

namespace rmpl::verifier {

/// A plant, alone or with the program that controls it.
struct Subject {
  const automata::Plant& plant;
  const automata::Program* program = nullptr;
};

}  // namespace rmpl::verifier
