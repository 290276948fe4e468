// Properties of a plant, as a file of them states: what is claimed, and what is free.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/logic/formula.hpp"
#include "automata/origin.hpp"
#include "automata/time/time.hpp"

namespace rmpl::automata {

/// A named property (semantics 7).
struct PlantProperty {
  enum class Claim {
    never,    ///< `formula` holds in no state that can be reached
    reach,    ///< it holds in some
    response  ///< once it has held, `then` holds at most `within` later
  };
  /// How many controls may be off their idle value in one step.
  enum class Commands { none, one, any };

  std::string name;
  Origin origin;
  Claim claim = Claim::never;
  Formula formula = constant(true);
  Formula then = constant(true);
  Ticks within;
  std::optional<Ticks> period;  ///< sampled time; none: dense
  unsigned faults = 0;
  Commands commands = Commands::one;
  bool entailed = false;
  std::vector<Assignment> from;  ///< modes, each component once; the others start as in the plant
  bool expect_violated = false;  ///< the verdict that is meant to come out
};

}  // namespace rmpl::automata
