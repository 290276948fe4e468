// Properties of a plant, and of a program that controls it, as a file of them states: what is claimed, what is free.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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
    probability,    ///< `formula` comes to hold up to `within` with a probability of `bound` at most, or at least
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

  /// Of the failure that the property excludes, worst first (ECSS-Q-ST-30-02C).
  enum class Severity { catastrophic, critical, major, minor };

  std::string name;
  Origin origin;
  Claim claim = Claim::never;
  bool of_program = false;  ///< of the plant under the program; else under free commands
  Formula formula = constant(true);
  Formula then = constant(true);
  Ticks within;                 ///< of a probability infinite: ever
  double bound = 0;             ///< of a probability
  bool at_least = false;        ///< of a probability; else at most
  std::optional<Ticks> period;  ///< sampled time; none: dense
  unsigned faults = 0;
  bool faults_stated = false;         ///< else runs of a probability have any number
  Commands commands = Commands::one;  ///< of a plant alone
  bool entailed = false;
  bool allow_stuck = false;      ///< under a program: it is not asked along with it whether a run gets stuck
  std::vector<Assignment> from;  ///< modes, each component once; the others start as in the plant
  bool hazard = false;           ///< what it excludes is harm
  std::optional<Severity> severity;
  bool expect_violated = false;                ///< the verdict that is meant to come out
  std::vector<std::string> requirements = {};  ///< that it verifies
  std::size_t plant = 0;                       ///< that the formulas are about: its position in the document
};

/// `catastrophic`, `critical`, `major` or `minor`.
constexpr std::string_view name_of(PlantProperty::Severity severity) {
  using Severity = PlantProperty::Severity;
  switch (severity) {
    case Severity::catastrophic:
      return "catastrophic";
    case Severity::critical:
      return "critical";
    case Severity::major:
      return "major";
    case Severity::minor:
      return "minor";
  }
  return "";
}

}  // namespace rmpl::automata
