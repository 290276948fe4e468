// A plant outside the process: the conversation of commands and answers, and its time (docs/execute.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/cycle/clock.hpp"
#include "runtime/executive/live/answers.hpp"
#include "runtime/executive/live/channel.hpp"
#include "runtime/executive/live/inbox.hpp"
#include "runtime/executive/live/outbox.hpp"
#include "runtime/executive/plant/plant_interface.hpp"
#include "runtime/executive/trace/json_line.hpp"

namespace rmpl::runtime {

struct LiveOptions {
  enum class Time {
    wall,      ///< a cycle takes as long as it says
    lock_step  ///< a cycle takes as long as the plant's answer does, and time is simulated
  };
  Time time = Time::wall;
  automata::Ticks patience = automata::Ticks::of_seconds(10);  ///< in lock-step: for an answer, or a plant; above 0
  std::function<bool()> interrupted = [] { return false; };    ///< asked while waiting
  std::vector<automata::Monitor> monitors = {};                ///< what makes readings of the plant's numbers
};

/// Each cycle, one line to the plant: `{"cycle":7,"time":3,"until":3.5,"command":{…}}`, with all control variables; and
/// one line back, an `Answer`, which acknowledges the command and has the readings at the end of the cycle. What the
/// plant does not say in time is not observed, and the estimator goes on without. Whatever goes wrong is among the
/// happenings of its cycle, each kind once, and nothing that the plant does throws.
class LivePlant final : public PlantInterface, public Clock {
 public:
  /// Cycle k is to end at k * `period`. Keeps references to `model` and `channel`.
  LivePlant(const automata::Plant& model, Channel& channel, automata::Ticks period, LiveOptions options);

  void issue(const automata::ControlAction& action, automata::Ticks now) override;
  const automata::Observation& sense(automata::Ticks now) override;
  void overhear(const automata::Modes& /*estimate*/, automata::Ticks /*now*/) override {}
  [[nodiscard]] const automata::Modes* truth() const override { return nullptr; }
  [[nodiscard]] const std::vector<Event>& happenings() const override { return happenings_; }
  [[nodiscard]] std::span<const Sample> samples() const override { return samples_; }
  [[nodiscard]] const Monitors* monitors() const override { return options_.monitors.empty() ? nullptr : &monitors_; }
  [[nodiscard]] bool more_to_come() const override { return false; }

  [[nodiscard]] automata::Ticks now() const override;
  /// Talks to the plant meanwhile.
  void wait_until(automata::Ticks time) override;

  /// Cycles in a row, up to the last one, in which no plant was there when they began.
  [[nodiscard]] std::uint64_t cycles_without() const { return cycles_without_; }
  [[nodiscard]] std::uint64_t acknowledged() const { return acknowledged_; }

 private:
  /// Things of one kind in one cycle: the first is told, the others are counted.
  struct Several {
    std::string first;
    std::uint64_t count = 0;
    void add(const std::string& message);
  };

  void compose(const automata::ControlAction& action, automata::Ticks now);
  void meet();
  void part();
  void handle(Channel::News news, const std::string& bytes);
  void read_lines();
  void read(const Inbox::Line& line);
  void keep(const Answer& answer);
  void tell(Event::Kind kind, std::string message);
  void tell(Event::Kind kind, Several& several, const char* others);
  [[nodiscard]] std::string why_unacknowledged() const;

  const automata::Plant& model_;
  Channel& channel_;
  const automata::Ticks period_;
  const LiveOptions options_;
  automata::Ticks simulated_;  ///< the time, in lock-step
  std::uint64_t cycle_ = 0;
  JsonLine line_;
  Outbox outbox_;
  Inbox inbox_;
  std::unique_ptr<Answers> answers_;  ///< of the plant that is there; null where none is
  std::uint64_t connections_ = 0;
  std::uint64_t cycles_without_ = 0;
  std::uint64_t acknowledged_ = 0;
  // Of this cycle:
  bool answered_ = false;
  bool parted_ = false;
  std::uint64_t lines_ = 0;
  Several refused_, late_;
  automata::Observation observations_;
  std::vector<Sample> samples_;
  std::vector<Event> events_;

  Monitors monitors_;
  automata::Observation read_back_;
  std::vector<Event> happenings_;
};

}  // namespace rmpl::runtime
