// Properties of a plant, and of a program that controls it, as a file of them states: what is claimed, what is free.
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

/// A named property (semantics 7), of a plant alone or under a program.
struct PlantProperty {
  enum class Claim {
    never,          ///< `formula` holds in no state that can be reached
    reach,          ///< it holds in some
    response,       ///< once it has held, `then` holds at most `within` later
    eventually,     ///< it holds at some time up to `within`, on every run
    finally,        ///< it holds where the program ends
    stuck,          ///< something can follow everywhere, and time passes
    goal_conflict,  ///< goals never contradict each other
    no_plan,        ///< no goal is without a plan
    endless_wait,   ///< no wait lasts for ever
    termination,    ///< the program ends on every run
    undone          ///< no command for reward takes away what a goal achieved
  };
  /// How many controls may be off their idle value in one step.
  enum class Commands { none, one, any };

  std::string name;
  Origin origin;
  Claim claim = Claim::never;
  bool of_program = false;  ///< of the plant under the program; else under free commands
  Formula formula = constant(true);
  Formula then = constant(true);
  Ticks within;
  std::optional<Ticks> period;  ///< sampled time; none: dense
  unsigned faults = 0;
  Commands commands = Commands::one;  ///< of a plant alone
  bool entailed = false;
  std::vector<Assignment> from;  ///< modes, each component once; the others start as in the plant
  bool expect_violated = false;  ///< the verdict that is meant to come out
};

}  // namespace rmpl::automata
