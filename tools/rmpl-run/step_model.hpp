// What `rmpl-run step` runs: a scenario made of the files of the command line, and of goals that are asked for by hand.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "automata/scenario.hpp"
#include "compiler/session/compiler.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "runtime/executive/step/flight_steps.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

struct StepOptions {
  std::vector<std::string> files;          ///< PROGRAM PLANT, PLANT, or a file of scenarios
  std::string only;                        ///< which of several scenarios
  std::vector<std::string> monitors = {};  ///< of a file of scenarios: how channels are read
  std::string main;
  std::string trace;
  std::optional<automata::Ticks> cycle;     ///< of a scenario its own
  std::optional<automata::Ticks> duration;  ///< likewise
  std::optional<std::uint64_t> seed;
  runtime::ScenarioOptions engines;
};

/// The document behind a session. A goal that is asked for by hand is a program: the one that was given up to then, and
/// the goal from then on; so a session that is saved is a scenario with a program like any other.
class StepModel {
 public:
  /// Reads the files and tells their diagnostics. Throws Rejected or base::InputError where they are wrong.
  StepModel(StepOptions options, const Common& common);

  [[nodiscard]] const automata::Document& document() const { return compilation_->document(); }
  [[nodiscard]] const automata::Plant& plant() const { return document().plant_of(scenario_); }
  [[nodiscard]] const automata::Program& program() const { return document().programs[scenario_.program]; }
  /// From its start. Throws base::InputError where the model has no state to start in.
  [[nodiscard]] std::unique_ptr<runtime::FlightSteps> fly(std::vector<runtime::Choice> choices = {}) const;

  /// From `time` on this is asked for, and nothing else; empty: nothing is. `cycle`: that have ended by then. Throws
  /// Rejected where it is no goal for the plant, base::InputError where goals cannot be asked for; then nothing
  /// changes.
  void ask_for(const std::string& goal, automata::Ticks time, std::uint64_t cycle);
  /// Goals that were asked for after so many cycles are forgotten, not those that were there; whether there were any.
  bool forget_goals_after(std::uint64_t cycle);
  /// What was asked for by hand last; nothing where the program is as it was given.
  [[nodiscard]] std::optional<std::string> asked() const;

  /// Writes the flight up to now as a scenario, with its program beside it where goals were asked for by hand; the
  /// names of the files that were written. Throws base::InputError where that cannot be.
  [[nodiscard]] std::vector<std::string> save(const std::string& path, const runtime::FlightSteps& flight) const;

 private:
  struct Goal {
    std::string text;  ///< empty: nothing
    automata::Ticks from;
    std::uint64_t cycle = 0;
  };

  void open();
  void compile_with_goals();
  void choose_scenario();
  [[nodiscard]] std::string program_text(const std::string& import) const;
  [[nodiscard]] automata::Scenario own_scenario() const;

  enum class Kind { plant, program, scenario };
  StepOptions options_;
  const Common& common_;
  Kind kind_ = Kind::plant;
  std::string entry_;  ///< the definition that the program starts with
  std::vector<Goal> goals_;
  std::optional<compiler::Compilation> compilation_;
  automata::Scenario scenario_;
};

}  // namespace rmpl::tools
