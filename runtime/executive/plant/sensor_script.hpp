// Readings that a scenario dictates: overrides at given times, and rules on the command and estimate streams.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "automata/plant.hpp"
#include "automata/scenario.hpp"
#include "automata/state.hpp"

namespace rmpl::runtime {

/// The rule-based simulator of thesis 7.2.1: it eavesdrops on commands and estimates, and injects observations some
/// cycles later, at the end of the cycle that begins with the command, or after the estimate, at the soonest. A reading
/// holds from its time on, for its duration; where several speak of one sensor, the one that began last is heard, and
/// of those that began together the one written last, overrides before rules.
class SensorScript {
 public:
  /// Keeps references to both.
  SensorScript(const automata::Plant& plant, const automata::Scenario& scenario);

  /// The command in force from `now` on. A rule fires when it holds where it did not hold for the command before.
  void hear_command(const automata::ControlAction& action, automata::Ticks now);
  void hear_estimate(const automata::Modes& modes, automata::Ticks now);
  /// Puts the readings that hold at `now` into `observation`, which is sorted by variable. `now` never falls.
  void apply(automata::Observation& observation, automata::Ticks now);
  /// Whether a reading that has not begun yet is in store.
  [[nodiscard]] bool pending() const { return !pending_.empty(); }

 private:
  struct Reading {
    automata::Ticks from;
    automata::Ticks until;  ///< exclusive
    std::size_t order;      ///< as written
    automata::Assignment reading;
  };
  struct Trigger {
    const automata::Rule* rule;
    std::size_t order;
    bool held = false;  ///< in the cycle before
  };

  template <class ValueOf>
  void fire(automata::Rule::Stream stream, const ValueOf& value_of, automata::Ticks now);
  void schedule(Reading reading);
  void begin(const Reading& reading);

  const automata::Plant& plant_;
  automata::Ticks cycle_;
  std::vector<Trigger> triggers_;
  std::vector<Reading> pending_;  ///< the next to begin stands last
  std::vector<Reading> active_;   ///< in order of beginning
  automata::ControlAction last_action_;
  automata::Modes last_modes_;
};

}  // namespace rmpl::runtime
