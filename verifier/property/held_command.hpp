// Modes that last only while a command is held (semantics 7).
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "automata/plant.hpp"
#include "automata/state.hpp"

namespace rmpl::verifier {

/// A mode that nominal transitions end by some time, or at once, with all controls idle, and that none ends while one
/// control is off its idle value, whatever others do.
struct HeldMode {
  automata::ComponentId component;
  automata::ModeId mode;
  automata::Assignment command;
};

/// The first of these components that has one; nothing where none has. Guards are read by their words: commands that
/// come by way of other attributes are not seen. Cost: the guards, times the values of the controls that they read.
std::optional<HeldMode> find_held_mode(const automata::Plant& plant, std::span<const automata::ComponentId> components);

}  // namespace rmpl::verifier
