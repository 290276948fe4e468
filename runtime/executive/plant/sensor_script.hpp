// Readings that a scenario dictates: samples of channels and overrides at given times, and rules on the command and
// estimate streams.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "automata/plant.hpp"
#include "automata/scenario.hpp"
#include "automata/state.hpp"
#include "runtime/executive/trace/event.hpp"
#include "runtime/telemetry/monitors.hpp"
#include "runtime/telemetry/sample.hpp"

namespace rmpl::runtime {

/// The rule-based simulator of thesis 7.2.1: it eavesdrops on commands and estimates, and injects observations some
/// cycles later, at the end of the cycle that begins with the command, or after the estimate, at the soonest. A reading
/// holds from its time on, for its duration; where several speak of one sensor, the one that began last is heard, and
/// of those that began together the one written last, overrides before rules. Below these, from the first sample of its
/// channel on, an attribute reads what its monitor makes of the samples, or nothing where that has no value.
class SensorScript {
 public:
  /// Keeps references to both. Throws base::InputError where no monitor of the scenario reads a channel of its samples.
  SensorScript(const automata::Plant& plant, const automata::Scenario& scenario);

  /// The command in force from `now` on. A rule fires when it holds where it did not hold for the command before.
  void hear_command(const automata::ControlAction& action, automata::Ticks now);
  void hear_estimate(const automata::Modes& modes, automata::Ticks now);
  /// Puts the readings that hold at `now` into `observation`, which is sorted by variable. `now` never falls.
  void apply(automata::Observation& observation, automata::Ticks now);
  /// Whether a reading that has not begun yet, or a sample, is in store.
  [[nodiscard]] bool pending() const { return !pending_.empty() || next_sample_ < samples_.size(); }

  /// The samples that came with the last `apply`, in order of time.
  [[nodiscard]] const std::vector<Sample>& samples() const { return heard_; }
  /// What makes readings of them; null where the scenario has none.
  [[nodiscard]] const Monitors* monitors() const { return samples_.empty() ? nullptr : &monitors_; }
  /// Adds what there is to tell of samples that gave no reading, since this was asked last.
  void add_remarks(std::vector<Event>& happenings);

 private:
  struct Reading {
    automata::Ticks from;
    automata::Ticks until;  ///< exclusive
    std::size_t order;      ///< as written
    automata::Assignment reading;
  };
  struct TimedSample {
    automata::Ticks at;
    Sample sample;
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
  void take_samples(automata::Ticks now);
  void apply_monitors(automata::Observation& observation, automata::Ticks now) const;

  const automata::Plant& plant_;
  automata::Ticks cycle_;
  std::vector<Trigger> triggers_;
  std::vector<Reading> pending_;  ///< the next to begin stands last
  std::vector<Reading> active_;   ///< in order of beginning
  Monitors monitors_;
  std::vector<TimedSample> samples_;  ///< by time
  std::size_t next_sample_ = 0;       ///< that has not come yet
  std::vector<Sample> heard_;         ///< in the last `apply`
  automata::ControlAction last_action_;
  automata::Modes last_modes_;
};

}  // namespace rmpl::runtime
