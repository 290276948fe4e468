// What a block diagram shows of a plant's interconnections: ports, lines between two of them, notes for the rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "automata/plant.hpp"
#include "compiler/diagram/blocks.hpp"
#include "compiler/diagram/flow.hpp"

namespace rmpl::compiler {

/// All interconnections of just these two variables.
struct Line {
  automata::VariableId from, to;
  std::vector<std::size_t> interconnections;
};

/// All interconnections with these ends: of one variable, or of more than two.
struct Note {
  Flow flow;
  std::vector<std::size_t> interconnections;
};

/// Interconnections that have no end in the picture, or all ends in one folded module, are left out.
struct Wiring {
  enum class Side { left, right };
  std::map<automata::VariableId, Side> ports;  ///< what is drawn, and at which side of its block
  std::vector<Line> lines;                     ///< in order of their first interconnection
  std::vector<Note> notes;                     ///< likewise
  std::vector<bool> commanded, observed;       ///< per variable
};

Wiring wiring_of(const automata::Plant& plant, const Blocks& blocks);

}  // namespace rmpl::compiler
