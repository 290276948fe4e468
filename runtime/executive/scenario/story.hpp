// Tells a run to people: a line where something changes, nothing where all goes on.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "automata/program.hpp"
#include "runtime/executive/scenario/style.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// New goals, commands, changes of the estimated modes with faults as such, what happens to the plant, and events.
/// What repeats in the next cycle is not told again.
class Story final : public CycleObserver {
 public:
  using Tell = std::function<void(const std::string& line)>;

  Story(const automata::Plant& plant, Style style, Tell tell);

  void observe(const CycleRecord& record) override;

 private:
  void line(automata::Ticks time, std::string_view what, const std::string& text);
  void tell_goal(const CycleRecord& record);
  void tell_command(const CycleRecord& record);
  void tell_events(const CycleRecord& record);
  void tell_estimate(const CycleRecord& record);
  [[nodiscard]] std::string text_of(automata::Assignment assignment) const;

  const automata::Plant& plant_;
  Style style_;
  Tell tell_;
  // As of the cycle before:
  std::vector<automata::Assignment> goal_;
  automata::ControlAction command_;
  automata::Modes estimate_;
  std::vector<Event> events_;
};

}  // namespace rmpl::runtime
