// Scenarios: a program, a plant, what happens, what is expected (language.md "Scenarios").
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "automata/monitor.hpp"
#include "automata/phca.hpp"
#include "automata/plant.hpp"
#include "automata/program.hpp"

namespace rmpl::automata {

/// `at T fault x = m;` forces a mode in the simulated plant.
struct ForcedMode {
  Ticks at;
  ComponentId component;
  ModeId mode;
  Origin origin;
  /// Of software that was named by what it tells: that, and the other modes that would do as well.
  std::optional<Assignment> told = {};
  std::vector<ModeId> also = {};
  bool operator==(const ForcedMode&) const = default;

  [[nodiscard]] bool is_met_by(ModeId other) const {
    return other == mode || std::find(also.begin(), also.end(), other) != also.end();
  }
};

/// `at T observe x = v [for d];` overrides a sensor from `at` on, for `duration` or for ever.
struct SensorOverride {
  Ticks at;
  Ticks duration = Ticks::infinite();
  Assignment reading;
  Origin origin;
  bool operator==(const SensorOverride&) const = default;
};

/// `at T channel "P1" = 2.7;` is a sample of a channel, of which monitors make readings from then on.
struct ChannelSample {
  Ticks at;
  std::string channel;
  std::optional<double> number;  ///< none: a text
  std::string text;              ///< as written
  Origin origin;
  bool operator==(const ChannelSample&) const = default;
};

/// `at T command x = v [for d];` is sent in each cycle that begins from `at` on, before `duration` is over, whatever
/// the executive commands of that control.
struct GivenCommand {
  Ticks at;
  Ticks duration;
  Assignment command;
  Origin origin;
  bool operator==(const GivenCommand&) const = default;
};

/// `when command x = v after N cycles observe y = w [for d];` the rule-based simulation of thesis 7.2.1. Each time the
/// command in force satisfies `trigger` where it did not in the cycle before, the reading holds from `delay` on.
struct Rule {
  enum class Stream { command, estimate };
  Stream stream = Stream::command;
  Formula trigger;                 ///< over control variables, or over modes
  std::uint64_t delay_cycles = 0;  ///< used where `delay` is empty
  std::optional<Ticks> delay;
  Assignment reading;
  Ticks duration = Ticks::infinite();
  Origin origin;
  bool operator==(const Rule&) const = default;
};

/// What must come true. `truth` speaks of the simulated plant, else of the executive's estimate.
struct Expectation {
  enum class Kind {
    eventually,      ///< condition becomes true (after `after`, within `within` of it or of the start)
    never,           ///< condition is never true
    finished,        ///< the program ends (within `within`), and condition is true as it does
    never_finished,  ///< the program does not end (within `within`) with condition true
    goal_conflict,   ///< the program never asserts goals that contradict each other
    no_plan          ///< no goal is ever without a plan
  };
  Kind kind = Kind::eventually;
  bool truth = false;
  Formula condition = constant(true);
  std::optional<Formula> after;
  std::optional<Ticks> within;
  std::string text;                            ///< as written, without requirements
  std::vector<std::string> requirements = {};  ///< besides those of the scenario
  Origin origin;
  bool operator==(const Expectation&) const = default;
};

struct Scenario {
  std::string name;
  std::size_t program = 0;  ///< position in `Document::programs`; bound to the plant
  std::size_t plant = 0;    ///< position in `Document::plants`
  bool rules_only = false;  ///< the simulated plant follows the rules alone
  Ticks cycle = {Ticks::per_second / 2};
  Ticks duration = Ticks::of_seconds(3600);
  std::uint64_t seed = 0;
  std::vector<Assignment> truth;  ///< mode variables: the real initial modes that are given
  std::vector<ForcedMode> forced;
  std::vector<SensorOverride> overrides;
  std::vector<GivenCommand> commands;
  std::vector<ChannelSample> samples;
  std::vector<Monitor> monitors = {};  ///< what makes readings of the samples; not written, since it is another input
  std::vector<Rule> rules;
  std::vector<Expectation> expectations;
  std::vector<std::string> requirements = {};  ///< that it verifies, with all of its expectations
  Origin origin;
  bool operator==(const Scenario&) const = default;
};

/// All that one input set compiles to.
struct Document {
  std::vector<Plant> plants;
  std::vector<Program> programs;
  std::vector<ModelProgram> models;
  std::vector<Scenario> scenarios;
  bool operator==(const Document&) const = default;

  /// What a scenario's program, events and expectations are about.
  [[nodiscard]] const Plant& plant_of(const Scenario& scenario) const { return plants[scenario.plant]; }
};

}  // namespace rmpl::automata
