// A flight that stops before each cycle, with all that could come next, and goes back.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "automata/scenario.hpp"
#include "automata/step/plant_step.hpp"
#include "runtime/executive/scenario/scenario_flight.hpp"
#include "runtime/executive/scenario/story.hpp"
#include "runtime/executive/step/stepped_run.hpp"

namespace rmpl::runtime {

/// What was chosen in one cycle: an event of a scenario, in the words of scenarios.
struct Choice {
  std::uint64_t cycle = 0;  ///< that had ended before it
  std::variant<automata::ForcedMode, automata::GivenCommand, automata::SensorOverride> event;
};

/// A position is a number of cycles. What is chosen becomes an event of the scenario, and the flight is flown again up
/// to where it stands: so it is always the flight of `scenario()`, to the bit. Likewise it goes back by flying again,
/// which costs some 3 us a cycle for a plant of five components; a snapshot would have to copy estimator, planner and
/// their memories.
class FlightSteps final : public SteppedRun {
 public:
  /// Keeps references to the document. Throws base::InputError as ScenarioFlight does.
  FlightSteps(const automata::Document& document, automata::Scenario scenario, ScenarioOptions options,
              std::vector<Choice> choices = {});

  [[nodiscard]] const automata::Plant& plant() const override { return document_.plant_of(base_); }
  [[nodiscard]] const automata::Program& program() const override { return document_.programs[base_.program]; }
  [[nodiscard]] automata::Theory& theory() override { return step_.theory(); }
  [[nodiscard]] std::uint64_t position() const override { return done_; }
  [[nodiscard]] automata::Ticks time() const override { return time_; }
  [[nodiscard]] Stop stop() override;
  [[nodiscard]] std::vector<Prospect> ahead() override;
  [[nodiscard]] automata::Ticks next_time() const override { return time_ + base_.cycle; }
  /// The run is over at the duration of the scenario. What is thrown leaves the flight where it stands, and what was
  /// chosen for this cycle is forgotten.
  bool advance(const Look& look) override;
  /// What was chosen from then on is forgotten. Throws Interrupted where the options say so; then the session is over.
  void go_back_to(std::uint64_t position) override;
  [[nodiscard]] std::string cannot_answer(const automata::Formula& formula) const override;
  std::vector<std::string> take_story() override;

  /// Whether anything but readings and commands can be chosen: whether there is a truth.
  [[nodiscard]] bool has_truth() const { return !base_.rules_only; }
  /// The component is in this mode at the end of the cycle that begins.
  void force(automata::ComponentId component, automata::ModeId mode);
  /// The command of the cycle that begins has this value of a control.
  void command(automata::Assignment command);
  /// The sensor reads this from the end of the cycle that begins, for a duration or for ever.
  void observe(automata::Assignment reading, automata::Ticks duration);

  /// The last cycle that has ended, whole; of the start cycle 0.
  [[nodiscard]] const CycleRecord& last() const { return last_; }
  /// What has been decided for the cycle that begins: its marking, goals, command and events.
  [[nodiscard]] const CycleRecord& decided() { return flight_->executive().record(); }
  /// Whether the program has ended.
  [[nodiscard]] bool ended() const { return ended_; }

  [[nodiscard]] const std::vector<Choice>& choices() const { return choices_; }
  /// The scenario with what was chosen.
  [[nodiscard]] const automata::Scenario& scenario() const { return scenario_; }

 private:
  void choose(Choice choice);
  void assemble();
  void fly_again_to(std::uint64_t position);
  void go_on(automata::Modes& modes, std::vector<automata::Ticks>& since, automata::Modes now);
  void look_at(const CycleRecord& record);
  void begin();
  const CycleRecord& carry_out();

  const automata::Document& document_;
  const automata::Scenario base_;
  ScenarioOptions options_;
  std::vector<Choice> choices_;
  automata::Scenario scenario_;
  automata::PlantStep step_;
  std::unique_ptr<ScenarioFlight> flight_;
  std::unique_ptr<Story> story_;
  std::vector<std::string> lines_;
  std::uint64_t done_ = 0;  ///< cycles that have ended
  automata::Ticks time_;
  bool ended_ = false;
  CycleRecord last_;
  std::vector<std::optional<std::string>> diagnosed_;  ///< per component: the evidence of its fault
  automata::Modes truth_, estimate_;
  std::vector<automata::Ticks> truth_since_, estimate_since_;  ///< by component: when its clock began
};

}  // namespace rmpl::runtime
