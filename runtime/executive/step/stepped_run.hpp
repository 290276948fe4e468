// A run that is stepped through, forth and back: a flight that goes on, or a trace of one that is over.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "automata/logic/theory.hpp"
#include "automata/program.hpp"
#include "automata/scenario.hpp"
#include "runtime/executive/scenario/expectations.hpp"
#include "runtime/executive/step/stop.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// It stands at a position, from 0: the number of steps from the start.
class SteppedRun {
 public:
  /// Shown each cycle that ends, with whether the program has ended in it.
  using Look = std::function<void(const CycleRecord& record, bool ended)>;

  virtual ~SteppedRun() = default;
  [[nodiscard]] virtual const automata::Plant& plant() const = 0;
  /// One without locations where the run has none.
  [[nodiscard]] virtual const automata::Program& program() const = 0;
  [[nodiscard]] virtual automata::Theory& theory() = 0;
  [[nodiscard]] virtual std::uint64_t position() const = 0;
  [[nodiscard]] virtual automata::Ticks time() const = 0;
  [[nodiscard]] virtual Stop stop() = 0;
  /// What may come next; empty where nothing is open.
  [[nodiscard]] virtual std::vector<Prospect> ahead() = 0;
  /// When the step that begins ends.
  [[nodiscard]] virtual automata::Ticks next_time() const = 0;
  /// Takes one step; false, and no step, where the run is over. Throws base::InputError where nothing can follow.
  virtual bool advance(const Look& look) = 0;
  /// Goes back to a position before this one.
  virtual void go_back_to(std::uint64_t position) = 0;
  /// Whether all knowledge atoms of a formula can be answered; else why not.
  [[nodiscard]] virtual std::string cannot_answer(const automata::Formula& formula) const = 0;
  /// What the last steps told, a line each; afterwards none.
  virtual std::vector<std::string> take_story() = 0;
};

/// Something that is waited for while a run goes on: as an expectation of a scenario is judged.
class Watch {
 public:
  /// `truth`: of the simulated plant, else of the estimate. Keeps a reference to the run.
  Watch(SteppedRun& run, automata::Formula formula, bool truth);
  /// Looks at a cycle; whether it holds at its end.
  bool holds(const CycleRecord& record, bool ended);

 private:
  SteppedRun& run_;
  automata::Scenario asked_;                  ///< with the formula as its one expectation
  std::optional<Expectations> expectations_;  ///< that have not been met so far
};

}  // namespace rmpl::runtime
