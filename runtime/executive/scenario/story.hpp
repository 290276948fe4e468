// Tells a run to people while it goes on: a line where something changes, nothing where all goes on.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/program.hpp"
#include "automata/scenario.hpp"
#include "base/painter.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/scenario/sample_story.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// What of a run is told.
struct StoryFocus {
  std::vector<automata::ComponentId> components;  ///< what is about these, and what is about none; empty: all
  automata::Ticks from;                           ///< both inclusive
  automata::Ticks to = automata::Ticks::infinite();
};

/// Goals that come and go with the lines that assert them, commands and waits with their reasons, samples of channels
/// with what is read of them, changes of the estimated modes with faults as such, what happens to the plant, and
/// events. What repeats in the next cycle is not told again, but for a command that goes on: once.
class Story final : public CycleObserver {
 public:
  using Tell = std::function<void(const std::string& line)>;

  /// Keeps references to the plant and the program.
  Story(const automata::Plant& plant, const automata::Program& program, MomentColumn column, base::Painter painter,
        StoryFocus focus, Tell tell);

  void observe(const CycleRecord& record) override;

 private:
  using Component = std::optional<automata::ComponentId>;

  void tell_goals(const CycleRecord& record);
  void tell_action(const CycleRecord& record);
  void tell_events(const CycleRecord& record);
  void tell_samples(const CycleRecord& record);
  void tell_estimate(const CycleRecord& record);
  void line(automata::Ticks time, std::string_view what, const std::string& text, Component about);
  [[nodiscard]] std::string why_diagnosed(const CycleRecord& record, automata::ComponentId component) const;
  [[nodiscard]] std::string goal_without_plan(const automata::Goals& goals, const Reason& why) const;
  [[nodiscard]] std::string impasse(const CycleRecord& record, const Event& event) const;
  [[nodiscard]] bool is_told(Component about) const;
  [[nodiscard]] bool is_action_told(const CycleRecord& record) const;
  [[nodiscard]] std::string text_of(automata::Assignment assignment) const;

  const automata::Plant& plant_;
  const automata::Program& program_;
  MomentColumn column_;
  base::Painter painter_;
  StoryFocus focus_;
  Tell tell_;
  SampleStory samples_;
  // As of the cycle before:
  automata::Goals goals_;
  automata::ControlAction command_;
  bool told_again_ = false;  ///< that the command goes on
  Reason waits_;             ///< of the wait that was told, if the cycle before waited
  automata::Modes estimate_;
  std::vector<Event> events_;
};

}  // namespace rmpl::runtime
